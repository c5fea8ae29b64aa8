// Pen and ink: paper faces, lines in object space, and hatching that stays on the object.
#include <array>

#include "hatchway/kit/far_lines.hpp"
#include "hatchway/kit/height_ramp.hpp"
#include "hatchway/kit/ink_look.hpp"
#include "hatchway/kit/lines_look.hpp"

namespace {

enum class Tone { none, plain, shaded, halftone };
constexpr std::array<std::string_view, 4> kTones{"none", "plain", "shaded", "halftone"};
constexpr const char* kHalftoneMap = "halftone";

class PenAndInk final : public hw::Style {
 public:
    void visit_params(hw::ParamVisitor& visitor) override
    {
        visit_lines(visitor);
        visitor.choice({"tone",
                        "What fills faces: nothing, even hatching by the hatch map, hatching by light and "
                        "shadow, or the same by a threshold over a priority map.",
                        hw::ParamChange::rebuild},
                       tone_, kTones);
        ink_look_.visit_params(visitor);
        fade_.visit_params(
            visitor,
            {{"fade", "Where hatching fades: nowhere, between two heights, or from the object's foot to its top."},
             {"fade_from_m", "Height where hatching begins to fade, metres; of fade object: share of its height."},
             {"fade_to_m", "Height where hatching is gone, metres; of fade object: share of its height."}});
        visitor.real({"shade", "Smooth gray shade under the ink."}, shade_, 0.0f, 1.0f);
        visitor.colour({"paper_colour", "Colour of faces."}, paper_);
        visitor.colour({"ink_colour", "Colour of silhouettes, borders and intersections."}, ink_);
        visitor.map({"hatch", "Hatch map of tone plain, where the level assigns none.", hw::ParamChange::rebuild},
                    hatch_, hw::MapKind::hatch);
        visitor.map(
            {"tonal", "Tonal map that hatches by light in place of computed strokes; of tone halftone a priority map.",
             hw::ParamChange::rebuild},
            tonal_, hw::MapKind::tonal);
        visitor.map({"ink", "Ink map: drawn detail such as courses of stone.", hw::ParamChange::rebuild}, ink_map_,
                    hw::MapKind::ink);
    }

    hw::Needs needs() const override
    {
        hw::Needs needs;
        lines_.add_needs(needs, look(), edges());
        ink_look_.add_needs(needs);
        needs.shadow = is_shaded() || shade_ > 0.0f ? hw::ShadowNeed::main_light : hw::ShadowNeed::none;
        needs.lightmap = needs.shadow != hw::ShadowNeed::none;
        if (tone_ == Tone::plain && !hatch_.value.empty()) needs.maps[hw::MapKind::hatch] = hatch_;
        if (is_shaded() && !tonal_.value.empty()) needs.maps[hw::MapKind::tonal] = tonal_;
        if (tone_ == Tone::halftone && tonal_.value.empty()) needs.maps[hw::MapKind::tonal] = hw::MapName{kHalftoneMap};
        if (!ink_map_.value.empty()) needs.maps[hw::MapKind::ink] = ink_map_;
        return needs;
    }

    void prepare(hw::ProgramCache& programs) override
    {
        std::string defines = lines_.defines();
        if (tone_ == Tone::plain) defines += "#define TONE_PLAIN 1\n";
        if (is_shaded()) defines += "#define TONE_SHADED 1\n";
        if (tone_ == Tone::halftone) defines += "#define TONE_HALFTONE 1\n";
        if (ink_look_.has_material_colour()) defines += "#define MATERIAL_COLOUR 1\n";
        program_ = programs.surface("pen_and_ink.frag", defines);
        lines_.prepare(programs);
    }

    void images(hw::Pass& pass, hw::Items items) override { lines_.images(pass, items); }

    void surfaces(hw::Pass& pass, hw::Items items) override
    {
        fade_.each(items, [&](const std::optional<hw::Ramp>& fade, hw::Items together) {
            hw::Uniforms uniforms;
            uniforms.set("shade", shade_).set("ink_fade", hw::share_uniform(fade ? 1.0f : 0.0f, fade));
            ink_look_.set_uniforms(uniforms, paper_);
            lines_.set_uniforms(uniforms, pass, look(), edges());
            pass.surfaces(program_, uniforms, together);
        });
    }

    void lines(hw::Pass& pass, hw::Items items) override
    {
        lines_.draw(pass, look(), items);
        lines_.draw_halo(pass, look(), edges());
    }

 private:
    hw::EdgeNeed edges() const { return {.crease_rad = crease_rad_, .intersections = intersection_width_px_ > 0.0f}; }

    hw::LineLook look() const
    {
        using hw::LineClass;
        hw::LineLook look;
        look.all({line_width_px_, crease_colour_});
        look[LineClass::valley].width_px = valley_width_px_;
        look[LineClass::silhouette] = {silhouette_width_px_, ink_};
        look[LineClass::border] = {border_width_px_, ink_};
        look[LineClass::intersection] = {intersection_width_px_, ink_};
        look.fold_weight = fold_weight_;
        look.stroke = stroke_;
        look.depth_taper = depth_taper_;
        look.far = far_;
        return look;
    }

    bool is_shaded() const { return tone_ == Tone::shaded || tone_ == Tone::halftone; }

    void visit_lines(hw::ParamVisitor& visitor)
    {
        lines_.visit_params(visitor);
        visitor.angle(
            {"crease_deg", "Edges folded by more than this are drawn from every viewpoint.", hw::ParamChange::rebuild},
            crease_rad_, 1.0f, 180.0f);
        visitor.real({"line_width_px", "Width of ridges and of edges that the artist marked."}, line_width_px_, 0.0f,
                     16.0f);
        visitor.real({"valley_width_px", "Width of creases that fold inward."}, valley_width_px_, 0.0f, 16.0f);
        visitor.real({"silhouette_width_px", "Width of silhouettes."}, silhouette_width_px_, 0.0f, 16.0f);
        visitor.real({"border_width_px", "Width of borders, where a surface ends."}, border_width_px_, 0.0f, 16.0f);
        visitor.real(
            {"intersection_width_px", "Width of lines where things go through each other; 0 does not look for them.",
             hw::ParamChange::rebuild},
            intersection_width_px_, 0.0f, 16.0f);
        visitor.colour({"crease_colour", "Colour of creases and of edges that the artist marked."}, crease_colour_);
        visitor.real({"fold_weight", "1 draws creases the thinner the less they are folded, 0 all alike."},
                     fold_weight_, 0.0f, 1.0f);
        visitor.real({"line_wobble_px", "How far lines stray sideways, as by hand; 0 rules them."}, stroke_.wobble_px,
                     0.0f, 12.0f);
        visitor.real({"line_bend_px", "From one bend of a line to the next, about."}, stroke_.bend_px, 4.0f, 500.0f);
        visitor.real({"line_overshoot_px", "How far lines run on beyond corners, smooth silhouettes apart."},
                     stroke_.overshoot_px, 0.0f, 40.0f);
        visitor.real({"line_taper_px", "Length over which lines grow thin to their ends, smooth silhouettes apart."},
                     stroke_.taper_px, 0.0f, 200.0f);
        visitor.real({"line_dash_px", "A dash and its gap, smooth silhouettes apart; 0 draws unbroken lines."},
                     stroke_.dash_px, 0.0f, 200.0f);
        visitor.real({"line_dash_share", "Of the dash in that."}, stroke_.dash_share, 0.05f, 1.0f);
        visitor.real({"depth_taper", "1 thins lines with distance, 0 keeps their width."}, depth_taper_, 0.0f, 1.0f);
        hw::visit_far_lines(visitor, far_);
    }

    float crease_rad_ = glm::radians(40.0f), depth_taper_ = 0.0f, fold_weight_ = 0.0f;
    float line_width_px_ = 1.2f, valley_width_px_ = 1.2f, silhouette_width_px_ = 1.9f, border_width_px_ = 1.9f;
    float intersection_width_px_ = 1.2f;
    hw::StrokeCharacter stroke_;
    hw::LinesLook lines_{hw::LinesLook::From::object};
    glm::vec3 crease_colour_{0.07f, 0.06f, 0.06f};
    hw::FarPolicy far_;
    Tone tone_ = Tone::shaded;
    hw::HeightRamp fade_{hw::HeightRamp::Over::none, {0.5f, 1.0f}};
    float shade_ = 0.0f;
    glm::vec3 paper_{1.0f}, ink_{0.07f, 0.06f, 0.06f};
    hw::InkLook ink_look_;
    hw::MapName hatch_{"fine"}, tonal_, ink_map_;
    hw::Program program_;
};

}  // namespace

HW_STYLE(pen_and_ink, "Paper faces, ink lines, hatch and ink maps, hatching by light and shadow", PenAndInk)
