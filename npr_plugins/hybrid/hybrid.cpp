// Hybrid: one object, photoreal where it is known and ink where it is conjecture.
#include <array>
#include <cmath>

#include "style/style.hpp"

namespace {

enum Gradient { kNone, kHeight, kObject };
constexpr std::array<std::string_view, 3> kGradients{"none", "height", "object"};
constexpr std::array<std::string_view, 4> kHatchSources{"model", "box", "cylinder", "principal"};
constexpr float kDegree = 0.017453293f;
constexpr float kCrossDeg = 70.0f;

glm::vec2 direction(float angle_deg)
{
    return {std::cos(angle_deg * kDegree), std::sin(angle_deg * kDegree)};
}

class Hybrid final : public hw::Style {
 public:
    void visit_params(hw::ParamVisitor& visitor) override
    {
        visitor.real({"ink_weight", "Share of ink where no gradient says otherwise; with one, its largest share."},
                     ink_weight_, 0.0f, 1.0f);
        visitor.choice(
            {"gradient", "Where ink rises: nowhere, between two heights, or from the object's foot to its top."},
            gradient_, kGradients);
        visitor.real({"from_m", "Height where ink begins, metres; of gradient object: share of its height."}, from_m_,
                     -1000.0f, 1000.0f);
        visitor.real({"to_m", "Height where ink has its full share; of gradient object: share of its height."}, to_m_,
                     -1000.0f, 1000.0f);
        visitor.colour({"tint", "Colour of the ink's paper: a free variable of the presentation, such as certainty."},
                       tint_);
        visitor.colour({"ink_colour", "Colour of lines."}, ink_);
        visitor.colour({"hatch_colour", "Colour of hatching and of ink maps."}, hatch_ink_);
        visitor.real(
            {"crease_deg", "Edges folded by more than this are drawn from every viewpoint.", hw::ParamChange::rebuild},
            crease_deg_, 1.0f, 180.0f);
        visitor.real({"line_width_px", "Width of lines."}, line_width_px_, 0.0f, 16.0f);
        visitor.real({"line_presence", "Share of the lines where the object is photoreal."}, line_presence_, 0.0f,
                     1.0f);
        visitor.flag({"far_thinning", "Thins crowded lines of far objects, so that they do not turn black."},
                     is_far_thinned_);
        visitor.real({"far_spacing_px", "Lines of an object that come closer together than this are thinned."},
                     far_spacing_px_, 1.0f, 40.0f);
        visitor.real({"spacing_px", "Between hatching strokes."}, spacing_px_, 2.0f, 64.0f);
        visitor.real({"stroke_width_px", "Width of hatching strokes."}, stroke_width_px_, 0.2f, 16.0f);
        visitor.choice({"hatch_direction",
                        "What strokes follow: the model's texture coordinates (a box where it has none), a box, "
                        "a cylinder, or the direction of strongest curvature.",
                        hw::ParamChange::rebuild},
                       hatch_source_, kHatchSources);
        visitor.real({"hatch_deg", "Direction of the first hatching; 0 is level on walls."}, hatch_deg_, -90.0f, 90.0f);
        visitor.real({"darkness", "Ink coverage of the darkest shadow."}, darkness_, 0.0f, 1.0f);
        visitor.real({"white_from", "Light above which paper stays white."}, white_from_, 0.05f, 1.0f);
        visitor.real({"shadow_below", "Light below which hatching is darkest."}, shadow_below_, 0.0f, 0.95f);
        visitor.real({"light_response", "How much light and shadow change the tone; 0 hatches evenly, half dark."},
                     light_response_, 0.0f, 1.0f);
        visitor.real({"material_tone", "How much dark materials darken the hatching."}, material_tone_, 0.0f, 1.0f);
        visitor.colour({"uncertain_colour", "Paper of objects of certainty 0; certainty 1 has the tint."}, uncertain_);
        visitor.real({"paper_from_material", "Share of the material's colour in the paper's."}, paper_from_material_,
                     0.0f, 1.0f);
        visitor.real({"ink_from_material", "Share of the material's colour in the hatching's."}, ink_from_material_,
                     0.0f, 1.0f);
    }

    hw::Needs needs() const override
    {
        hw::Needs needs;
        needs.edges = hw::EdgeNeed{.crease_rad = crease_deg_ * kDegree};
        needs.streams = {
            .tangent = true, .hatch_uv = true, .hatch_source = static_cast<hw::HatchSource>(hatch_source_)};
        needs.shadow = hw::ShadowNeed::main_light;
        needs.lightmap = true;
        return needs;
    }

    void prepare(hw::ProgramCache& programs) override
    {
        program_ = programs.surface("hybrid.frag", "#define TONE_SHADED 1\n#define MATERIAL_COLOUR 1\n");
    }

    void surfaces(hw::Pass& pass, hw::Layer, std::span<const hw::DrawItem> items) override
    {
        for (const hw::DrawItem& item : items) {
            const Range range = range_of(item);
            hw::Uniforms uniforms;
            uniforms.set("ink_range", glm::vec3(range.from_m, range.to_m, gradient_ == kNone ? 0.0f : 1.0f))
                .set("ink_weight", ink_weight_)
                .set("hatch_size_px", glm::vec4(spacing_px_, stroke_width_px_, 170.0f, 0.4f))
                .set("hatch_directions", glm::vec4(direction(hatch_deg_), direction(hatch_deg_ + kCrossDeg)))
                .set("tone_range", glm::vec4(darkness_, white_from_, shadow_below_, material_tone_))
                .set("paper_colour", hw::linear_colour(tint_))
                .set("uncertain_colour", hw::linear_colour(uncertain_))
                .set("ink_colour", hw::linear_colour(hatch_ink_))
                .set("from_material", glm::vec2(paper_from_material_, ink_from_material_))
                .set("shade", 0.0f)
                .set("light_response", light_response_)
                .set("ink_fade", glm::vec3(0.0f))
                .set("ink_map_look", glm::vec2(1.0f, 0.7f));
            pass.surfaces(program_, uniforms, {&item, 1});
        }
    }

    void lines(hw::Pass& pass, std::span<const hw::DrawItem> items) override
    {
        hw::LineLook look;
        look.width_px.fill(line_width_px_);
        look.colour.fill(ink_);
        look.crease_rad = crease_deg_ * kDegree;
        look.far = hw::far_policy(is_far_thinned_, far_spacing_px_);
        for (const hw::DrawItem& item : items) {
            hw::DrawItem faded = item;
            if (gradient_ != kNone && line_presence_ < 1.0f && !item.is_presence_inverted) {
                // Lines are there from where ink begins: a drawing needs its outlines before its hatching.
                const Range range = range_of(item);
                faded.presence.has_height = true;
                faded.presence.from_m = range.from_m - line_presence_ * (range.to_m - range.from_m);
                faded.presence.to_m = range.to_m - 0.5f * (range.to_m - range.from_m);
            }
            pass.lines(look, {&faded, 1});
        }
    }

 private:
    struct Range {
        float from_m;
        float to_m;
    };

    Range range_of(const hw::DrawItem& item) const
    {
        if (gradient_ != kObject || item.bounds_world.is_empty()) return {from_m_, to_m_};
        const double foot = item.bounds_world.min.y;
        const double height = item.bounds_world.size().y;
        return {static_cast<float>(foot + from_m_ * height), static_cast<float>(foot + to_m_ * height)};
    }

    float ink_weight_ = 1.0f, from_m_ = 0.25f, to_m_ = 0.75f;
    int gradient_ = kObject, hatch_source_ = 0;
    glm::vec3 tint_{1.0f}, ink_{0.07f, 0.06f, 0.06f}, hatch_ink_{0.24f, 0.22f, 0.21f};
    float crease_deg_ = 40.0f, line_width_px_ = 1.4f, line_presence_ = 0.0f;
    bool is_far_thinned_ = true;
    float far_spacing_px_ = 6.0f;
    float spacing_px_ = 4.5f, stroke_width_px_ = 0.8f, hatch_deg_ = 52.0f, darkness_ = 0.66f, white_from_ = 0.72f,
          shadow_below_ = 0.26f;
    float light_response_ = 1.0f, material_tone_ = 0.1f, paper_from_material_ = 0.0f, ink_from_material_ = 0.0f;
    glm::vec3 uncertain_{1.0f};
    hw::Program program_;
};

}  // namespace

HW_STYLE(hybrid, "Photoreal where known, pen and ink where conjecture, with a gradient between them", Hybrid)
