#pragma once

#include <algorithm>
#include <array>
#include <glm/trigonometric.hpp>

#include "hatchway/style/style.hpp"

namespace hw {

/// The two pens of a style that draws simple lines: where the surface turns away or ends, and where it folds.
struct TwoPens {
    float profile_width_px = 1.8f, inner_width_px = 1.2f;
    glm::vec3 profile_colour{0.07f, 0.06f, 0.06f}, inner_colour{0.07f, 0.06f, 0.06f};
    float crease_rad = glm::radians(40.0f);

    void visit_params(ParamVisitor& visitor);
    LineLook look() const;
    EdgeNeed edges() const { return {.crease_rad = crease_rad}; }
};

/// Where the lines of a style come from, for styles whose shader includes lines_look.glsl: the edges of the meshes,
/// drawn with all that a LineLook has, or the image edge_map, mixed into the faces, by normals and depth or by the
/// numbers of triangles. Profile edges have the pen of silhouettes; inner edges that of ridges. By numbers borders have
/// a pen of their own, but the width of silhouettes; where surfaces meet without a common corner is an intersection,
/// and nothing is known of creases. `look` and `edges` are the same in all calls.
struct LinesLook {
    enum class From { none, object, edge_map, ids };

    explicit LinesLook(From by_default) : from(by_default) {}

    From from;
    float halo_px = 0.0f;  ///< Of images: how far profile lines reach beyond their object.

    void visit_params(ParamVisitor& visitor);
    void add_needs(Needs& needs, const LineLook& look, const EdgeNeed& edges) const;
    /// What the style's program is compiled with.
    std::string defines() const;
    void prepare(ProgramCache& programs);

    /// In Style::images(), with all items of the style.
    void images(Pass& pass, Items items);
    /// All uniforms of lines_look.glsl.
    void set_uniforms(Uniforms& uniforms, const Pass& pass, const LineLook& look, const EdgeNeed& edges) const;
    /// In Style::lines(): the lines of these items, by the edges of their meshes.
    void draw(Pass& pass, const LineLook& look, Items items) const;
    /// In Style::lines(), once: the parts of profile lines that reach beyond the style's objects.
    void draw_halo(Pass& pass, const LineLook& look, const EdgeNeed& edges) const;

 private:
    bool is_image() const { return from == From::edge_map || from == From::ids; }
    bool has_halo() const { return is_image() && halo_px > 0.0f; }
    /// What the edge map is made of; output 0 or 1 of it has the depth.
    ImageKey source() const;
    LineClass inner_class() const { return from == From::ids ? LineClass::intersection : LineClass::ridge; }
    ImageKey edge_map(const LineLook& look, const EdgeNeed& edges) const;

    Program mask_program_, halo_program_;
    Image mask_;  // of this frame: how much of the style is seen where
};

inline void TwoPens::visit_params(ParamVisitor& visitor)
{
    using enum ParamChange;
    visitor.real({"profile_width_px", "Width of lines where the surface turns away or ends.", rebuild},
                 profile_width_px, 0.0f, 8.0f);
    visitor.real({"inner_width_px", "Width of creases.", rebuild}, inner_width_px, 0.0f, 8.0f);
    visitor.colour({"profile_colour", "Colour of lines where the surface turns away or ends."}, profile_colour);
    visitor.colour({"inner_colour", "Colour of creases."}, inner_colour);
    visitor.angle({"crease_deg", "Edges folded by more than this are drawn from every viewpoint.", rebuild}, crease_rad,
                  1.0f, 180.0f);
}

inline LineLook TwoPens::look() const
{
    LineLook look;
    look.all({inner_width_px, inner_colour});
    look[LineClass::silhouette] = look[LineClass::border] = {profile_width_px, profile_colour};
    return look;
}

inline void LinesLook::visit_params(ParamVisitor& visitor)
{
    static constexpr std::array<std::string_view, 4> kFrom{"none", "object", "edge_map", "ids"};
    visitor.choice({"lines_from",
                    "What lines are drawn by: nothing, the edges of the model, an image of edges in normals and depth, "
                    "or one of triangles that share no corner, which knows no creases.",
                    ParamChange::rebuild},
                   from, kFrom);
    visitor.real({"halo_px", "How far profile lines from an image reach beyond their object.", ParamChange::rebuild},
                 halo_px, 0.0f, 8.0f);
}

inline ImageKey LinesLook::source() const
{
    if (from == From::ids) return {"triangle_ids", {{"planes", true}}};
    return {"normal_depth", {{"format", std::string("rgba32f")}, {"normal", std::string("face")}}};
}

inline ImageKey LinesLook::edge_map(const LineLook& look, const EdgeNeed& edges) const
{
    // Lines thinner than a pixel are one pixel wide and fainter.
    const auto width_px = [&](LineClass pen) {
        return static_cast<double>(std::clamp(look[pen].width_px, 1.0f, 8.0f));
    };
    ImageKey key{"edge_map",
                 {{"width_px", width_px(LineClass::silhouette)},
                  {"inner_width_px", width_px(inner_class())},
                  {"halo_px", static_cast<double>(halo_px)}}};
    if (from == From::ids)
        key.params["operator"] = std::string("ids");
    else
        key.params["crease_deg"] = static_cast<double>(glm::degrees(edges.crease_rad));
    return key;
}

inline void LinesLook::add_needs(Needs& needs, const LineLook& look, const EdgeNeed& edges) const
{
    if (from == From::object) needs.edges = edges;
    if (is_image()) needs.images = {source(), edge_map(look, edges)};
}

inline std::string LinesLook::defines() const
{
    std::string defines = is_image() ? "#define LINES_FROM_EDGE_MAP 1\n" : "";
    if (from == From::ids) defines += "#define LINES_TELL_BORDERS 1\n";
    if (has_halo()) defines += "#define LINES_HALO 1\n";
    return defines;
}

inline void LinesLook::prepare(ProgramCache& programs)
{
    if (!has_halo()) return;
    mask_program_ = programs.surface("lines_mask.frag");
    halo_program_ = programs.full_screen("lines_halo.frag");
}

inline void LinesLook::images(Pass& pass, Items items)
{
    if (!has_halo()) return;
    mask_ = pass.render({.outputs = {{.format = PixelFormat::r8}}, .depth = TargetDepth::scene}, mask_program_, {},
                        items)[0];
}

/// Linear colour, and how strong.
inline glm::vec4 pen_uniform(const Pen& pen)
{
    return {linear_colour(pen.colour), pen.is_drawn ? std::min(pen.width_px, 1.0f) : 0.0f};
}

inline void LinesLook::set_uniforms(Uniforms& uniforms, const Pass& pass, const LineLook& look,
                                    const EdgeNeed& edges) const
{
    if (!is_image()) return;
    const ImageKey key = edge_map(look, edges);
    uniforms.set("edge_map", pass.image(key))
        .set("edge_source", pass.image(source(), from == From::ids ? 1 : 0))
        .set("profile_pen", pen_uniform(look[LineClass::silhouette]))
        .set("inner_pen", pen_uniform(look[inner_class()]));
    if (from == From::ids) uniforms.set("border_pen", pen_uniform(look[LineClass::border]));
    if (has_halo()) uniforms.set("edge_owner", pass.image(key, 1));
}

inline void LinesLook::draw(Pass& pass, const LineLook& look, Items items) const
{
    if (from == From::object) pass.lines(look, items);
}

inline void LinesLook::draw_halo(Pass& pass, const LineLook& look, const EdgeNeed& edges) const
{
    if (!has_halo()) return;
    const ImageKey key = edge_map(look, edges);
    pass.cover(halo_program_, Uniforms()
                                  .set("edge_map", pass.image(key))
                                  .set("edge_owner", pass.image(key, 1))
                                  .set("own_mask", mask_)
                                  .set("profile_pen", pen_uniform(look[LineClass::silhouette])));
}

}  // namespace hw
