// Pen and ink: paper faces, lines in object space, and hatching that stays on the object.
#include <array>
#include <cmath>

#include "style/style.hpp"

namespace {

enum Tone { kNoTone, kPlain, kShaded, kHalftone };
enum Fade { kNoFade, kHeight, kObject };
constexpr std::array<std::string_view, 4> kTones{"none", "plain", "shaded", "halftone"};
constexpr std::array<std::string_view, 3> kFades{"none", "height", "object"};
constexpr const char* kHalftoneMap = "halftone";
constexpr std::array<std::string_view, 4> kHatchSources{"model", "box", "cylinder", "principal"};
constexpr float kDegree = 0.017453293f;

glm::vec2 direction(float angle_deg)
{
    return {std::cos(angle_deg * kDegree), std::sin(angle_deg * kDegree)};
}

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
        visitor.real({"spacing_px", "Between hatching strokes."}, spacing_px_, 2.0f, 64.0f);
        visitor.real({"stroke_width_px", "Width of hatching strokes."}, stroke_width_px_, 0.2f, 16.0f);
        visitor.choice({"hatch_direction",
                        "What strokes follow: the model's texture coordinates (a box where it has none), a box, "
                        "a cylinder, or the direction of strongest curvature.",
                        hw::ParamChange::rebuild},
                       hatch_source_, kHatchSources);
        visitor.real({"hatch_deg", "Direction of the first hatching; 0 is level on walls."}, hatch_deg_, -90.0f, 90.0f);
        visitor.real({"cross_deg", "From the first direction to the one that crosses it."}, cross_deg_, 10.0f, 90.0f);
        visitor.real({"stroke_length_px", "Mean length of strokes; 0 rules endless lines."}, stroke_length_px_, 0.0f,
                     1000.0f);
        visitor.real({"wobble_px", "How far a stroke strays sideways."}, wobble_px_, 0.0f, 4.0f);
        visitor.real({"darkness", "Ink coverage of the darkest shadow."}, darkness_, 0.0f, 1.0f);
        visitor.real({"white_from", "Light above which paper stays white."}, white_from_, 0.05f, 1.0f);
        visitor.real({"shadow_below", "Light below which hatching is darkest."}, shadow_below_, 0.0f, 0.95f);
        visitor.real({"material_tone", "How much dark materials darken the hatching."}, material_tone_, 0.0f, 1.0f);
        visitor.real({"light_response", "How much light and shadow change the tone; 0 hatches evenly, half dark."},
                     light_response_, 0.0f, 1.0f);
        visitor.choice(
            {"fade", "Where hatching fades: nowhere, between two heights, or from the object's foot to its top."},
            fade_, kFades);
        visitor.real(
            {"fade_from_m", "Height where hatching begins to fade, metres; of fade object: share of its height."},
            fade_from_m_, -1000.0f, 1000.0f);
        visitor.real({"fade_to_m", "Height where hatching is gone, metres; of fade object: share of its height."},
                     fade_to_m_, -1000.0f, 1000.0f);
        visitor.real({"shade", "Smooth gray shade under the ink."}, shade_, 0.0f, 1.0f);
        visitor.colour({"paper_colour", "Colour of faces."}, paper_);
        visitor.colour({"ink_colour", "Colour of silhouettes, borders and intersections."}, ink_);
        visitor.colour(
            {"hatch_colour", "Colour of hatching and of ink maps: a little softer than lines, it stays behind them."},
            hatch_ink_);
        visitor.real(
            {"paper_from_material", "Share of the material's colour in the paper's.", hw::ParamChange::rebuild},
            paper_from_material_, 0.0f, 1.0f);
        visitor.real(
            {"ink_from_material", "Share of the material's colour in the hatching's.", hw::ParamChange::rebuild},
            ink_from_material_, 0.0f, 1.0f);
        visitor.colour({"uncertain_colour", "Paper of objects of certainty 0; certainty 1 has the paper's colour."},
                       uncertain_);
        visitor.map({"hatch", "Hatch map of tone plain, where the level assigns none.", hw::ParamChange::rebuild},
                    hatch_, hw::MapKind::hatch);
        visitor.map(
            {"tonal",
             "Tonal map that hatches by light in place of strokes that are reckoned; of tone halftone a priority map.",
             hw::ParamChange::rebuild},
            tonal_, hw::MapKind::tonal);
        visitor.map({"ink", "Ink map: drawn detail such as courses of stone.", hw::ParamChange::rebuild}, ink_map_,
                    hw::MapKind::ink);
        visitor.real({"ink_map_strength", "Of the ink map; 0 hides it."}, ink_map_strength_, 0.0f, 1.0f);
        visitor.real({"ink_map_detail", "Levels of the ink map by which it is drawn finer: more and thinner strokes."},
                     ink_map_detail_, -2.0f, 2.0f);
    }

    hw::Needs needs() const override
    {
        hw::Needs needs;
        needs.edges = hw::EdgeNeed{.crease_rad = crease_deg_ * kDegree, .intersections = intersection_width_px_ > 0.0f};
        needs.streams.hatch_uv = true;
        needs.streams.hatch_source = static_cast<hw::HatchSource>(hatch_source_);
        needs.shadow = is_shaded() || shade_ > 0.0f ? hw::ShadowNeed::main_light : hw::ShadowNeed::none;
        needs.lightmap = needs.shadow != hw::ShadowNeed::none;
        if (tone_ == kPlain && !hatch_.value.empty()) needs.maps[hw::MapKind::hatch] = hatch_;
        if (is_shaded() && !tonal_.value.empty()) needs.maps[hw::MapKind::tonal] = tonal_;
        if (tone_ == kHalftone && tonal_.value.empty()) needs.maps[hw::MapKind::tonal] = hw::MapName{kHalftoneMap};
        if (!ink_map_.value.empty()) needs.maps[hw::MapKind::ink] = ink_map_;
        return needs;
    }

    void prepare(hw::ProgramCache& programs) override
    {
        std::string defines;
        if (tone_ == kPlain) defines += "#define TONE_PLAIN 1\n";
        if (is_shaded()) defines += "#define TONE_SHADED 1\n";
        if (tone_ == kHalftone) defines += "#define TONE_HALFTONE 1\n";
        if (paper_from_material_ > 0.0f || ink_from_material_ > 0.0f) defines += "#define MATERIAL_COLOUR 1\n";
        program_ = programs.surface("pen_and_ink.frag", defines);
    }

    void surfaces(hw::Pass& pass, hw::Layer, std::span<const hw::DrawItem> items) override
    {
        if (fade_ != kObject) {
            draw(pass, {fade_from_m_, fade_to_m_}, items);
            return;
        }
        for (const hw::DrawItem& item : items) {
            const auto foot = static_cast<float>(item.bounds_world.min.y);
            const float height = item.bounds_world.is_empty() ? 1.0f : static_cast<float>(item.bounds_world.size().y);
            draw(pass, {foot + fade_from_m_ * height, foot + fade_to_m_ * height}, {&item, 1});
        }
    }

    void lines(hw::Pass& pass, std::span<const hw::DrawItem> items) override
    {
        using hw::LineClass;
        hw::LineLook look;
        look.width_px.fill(line_width_px_);
        look.width_px[int(LineClass::silhouette)] = silhouette_width_px_;
        look.width_px[int(LineClass::border)] = border_width_px_;
        look.width_px[int(LineClass::valley)] = valley_width_px_;
        look.width_px[int(LineClass::intersection)] = intersection_width_px_;
        look.colour.fill(crease_colour_);
        look.colour[int(LineClass::silhouette)] = look.colour[int(LineClass::border)] = ink_;
        look.colour[int(LineClass::intersection)] = ink_;
        look.fold_weight = fold_weight_;
        look.stroke = stroke_;
        look.crease_rad = crease_deg_ * kDegree;
        look.depth_taper = depth_taper_;
        look.far = hw::far_policy(is_far_thinned_, far_spacing_px_);
        pass.lines(look, items);
    }

 private:
    bool is_shaded() const { return tone_ == kShaded || tone_ == kHalftone; }

    void draw(hw::Pass& pass, const glm::vec2& fade, std::span<const hw::DrawItem> items)
    {
        hw::Uniforms uniforms;
        uniforms.set("hatch_size_px", glm::vec4(spacing_px_, stroke_width_px_, stroke_length_px_, wobble_px_))
            .set("hatch_directions", glm::vec4(direction(hatch_deg_), direction(hatch_deg_ + cross_deg_)))
            .set("tone_range", glm::vec4(darkness_, white_from_, shadow_below_, material_tone_))
            .set("paper_colour", hw::linear_colour(paper_))
            .set("ink_colour", hw::linear_colour(hatch_ink_))
            .set("uncertain_colour", hw::linear_colour(uncertain_))
            .set("from_material", glm::vec2(paper_from_material_, ink_from_material_))
            .set("shade", shade_)
            .set("light_response", light_response_)
            .set("ink_fade", glm::vec3(fade, fade_ == kNoFade ? 0.0f : 1.0f))
            .set("ink_map_look", glm::vec2(ink_map_strength_, ink_map_detail_));
        pass.surfaces(program_, uniforms, items);
    }

    void visit_lines(hw::ParamVisitor& visitor)
    {
        visitor.real(
            {"crease_deg", "Edges folded by more than this are drawn from every viewpoint.", hw::ParamChange::rebuild},
            crease_deg_, 1.0f, 180.0f);
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
        visitor.real({"line_overshoot_px", "How far lines run on beyond corners, silhouettes apart."},
                     stroke_.overshoot_px, 0.0f, 40.0f);
        visitor.real({"line_taper_px", "Length over which lines grow thin to their ends, silhouettes apart."},
                     stroke_.taper_px, 0.0f, 200.0f);
        visitor.real({"line_dash_px", "A dash and its gap, silhouettes apart; 0 draws unbroken lines."},
                     stroke_.dash_px, 0.0f, 200.0f);
        visitor.real({"line_dash_share", "Of the dash in that."}, stroke_.dash_share, 0.05f, 1.0f);
        visitor.real({"depth_taper", "1 thins lines with distance, 0 keeps their width."}, depth_taper_, 0.0f, 1.0f);
        visitor.flag({"far_thinning", "Thins crowded lines of far objects, so that they do not turn black."},
                     is_far_thinned_);
        visitor.real({"far_spacing_px", "Lines of an object that come closer together than this are thinned."},
                     far_spacing_px_, 1.0f, 40.0f);
    }

    float crease_deg_ = 40.0f, depth_taper_ = 0.0f, fold_weight_ = 0.0f;
    float line_width_px_ = 1.2f, valley_width_px_ = 1.2f, silhouette_width_px_ = 1.9f, border_width_px_ = 1.9f;
    float intersection_width_px_ = 1.2f;
    hw::StrokeCharacter stroke_;
    glm::vec3 crease_colour_{0.07f, 0.06f, 0.06f};
    bool is_far_thinned_ = true;
    float far_spacing_px_ = 6.0f;
    int tone_ = kShaded, hatch_source_ = 0, fade_ = kNoFade;
    float light_response_ = 1.0f, fade_from_m_ = 0.5f, fade_to_m_ = 1.0f;
    float spacing_px_ = 4.5f, stroke_width_px_ = 0.8f, stroke_length_px_ = 170.0f, wobble_px_ = 0.4f;
    float hatch_deg_ = 52.0f, cross_deg_ = 70.0f;
    float darkness_ = 0.66f, white_from_ = 0.72f, shadow_below_ = 0.26f, material_tone_ = 0.1f, shade_ = 0.0f;
    glm::vec3 paper_{1.0f}, ink_{0.07f, 0.06f, 0.06f}, hatch_ink_{0.24f, 0.22f, 0.21f}, uncertain_{1.0f};
    float paper_from_material_ = 0.0f, ink_from_material_ = 0.0f, ink_map_strength_ = 1.0f, ink_map_detail_ = 0.9f;
    hw::MapName hatch_{"fine"}, tonal_, ink_map_;
    hw::Program program_;
};

}  // namespace

HW_STYLE(pen_and_ink, "Paper faces, ink lines, hatch and ink maps, hatching by light and shadow", PenAndInk)
