// Hybrid: one object, photoreal where it is known and ink where it is conjecture.
#include <array>

#include "hatchway/style/style.hpp"

namespace {

enum class Gradient { none, height, object };
constexpr std::array<std::string_view, 3> kGradients{"none", "height", "object"};

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
        visitor.angle(
            {"crease_deg", "Edges folded by more than this are drawn from every viewpoint.", hw::ParamChange::rebuild},
            crease_rad_, 1.0f, 180.0f);
        visitor.real({"line_width_px", "Width of lines."}, line_width_px_, 0.0f, 16.0f);
        visitor.real({"line_presence", "Share of the lines where the object is photoreal."}, line_presence_, 0.0f,
                     1.0f);
        far_.visit_params(visitor);
        ink_look_.visit_params(visitor);
    }

    hw::Needs needs() const override
    {
        hw::Needs needs;
        needs.edges = hw::EdgeNeed{.crease_rad = crease_rad_};
        ink_look_.add_needs(needs);
        needs.shadow = hw::ShadowNeed::main_light;
        needs.lightmap = true;
        return needs;
    }

    void prepare(hw::ProgramCache& programs) override
    {
        program_ = programs.surface("hybrid.frag", "#define TONE_SHADED 1\n#define MATERIAL_COLOUR 1\n");
    }

    void surfaces(hw::Pass& pass, hw::Items items) override
    {
        for (const hw::DrawItem& item : items) {
            const Range range = range_of(item);
            hw::Uniforms uniforms;
            uniforms.set("ink_range", glm::vec3(range.from_m, range.to_m, gradient_ == Gradient::none ? 0.0f : 1.0f))
                .set("ink_weight", ink_weight_)
                .set("shade", 0.0f)
                .set("ink_fade", glm::vec3(0.0f));
            ink_look_.set_uniforms(uniforms, tint_);
            pass.surfaces(program_, uniforms, {&item, 1});
        }
    }

    void lines(hw::Pass& pass, hw::Items items) override
    {
        hw::LineLook look;
        look.all({line_width_px_, ink_});
        look.far = far_;
        for (const hw::DrawItem& item : items) {
            hw::DrawItem faded = item;
            if (gradient_ != Gradient::none && line_presence_ < 1.0f && !item.is_presence_inverted) {
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
        if (gradient_ != Gradient::object || item.bounds_world.is_empty()) return {from_m_, to_m_};
        const double foot = item.bounds_world.min.y;
        const double height = item.bounds_world.size().y;
        return {static_cast<float>(foot + from_m_ * height), static_cast<float>(foot + to_m_ * height)};
    }

    float ink_weight_ = 1.0f, from_m_ = 0.25f, to_m_ = 0.75f;
    Gradient gradient_ = Gradient::object;
    glm::vec3 tint_{1.0f}, ink_{0.07f, 0.06f, 0.06f};
    float crease_rad_ = glm::radians(40.0f), line_width_px_ = 1.4f, line_presence_ = 0.0f;
    hw::FarPolicy far_;
    hw::InkLook ink_look_;
    hw::Program program_;
};

}  // namespace

HW_STYLE(hybrid, "Photoreal where known, pen and ink where conjecture, with a gradient between them", Hybrid)
