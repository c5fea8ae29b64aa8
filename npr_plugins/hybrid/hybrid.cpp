// Hybrid: one object, photoreal where it is known and ink where it is conjecture.
#include "hatchway/kit/far_lines.hpp"
#include "hatchway/kit/height_ramp.hpp"
#include "hatchway/kit/ink_look.hpp"
#include "hatchway/kit/lines_look.hpp"

namespace {

class Hybrid final : public hw::Style {
 public:
    void visit_params(hw::ParamVisitor& visitor) override
    {
        visitor.real({"ink_weight", "Share of ink where no gradient says otherwise; with one, its largest share."},
                     ink_weight_, 0.0f, 1.0f);
        gradient_.visit_params(
            visitor,
            {{"gradient", "Where ink rises: nowhere, between two heights, or from the object's foot to its top."},
             {"from_m", "Height where ink begins, metres; of gradient object: share of its height."},
             {"to_m", "Height where ink has its full share; of gradient object: share of its height."}});
        visitor.colour({"tint", "Colour of the ink's paper: a free variable of the presentation, such as certainty."},
                       tint_);
        visitor.colour({"ink_colour", "Colour of lines."}, ink_);
        visitor.angle(
            {"crease_deg", "Edges folded by more than this are drawn from every viewpoint.", hw::ParamChange::rebuild},
            crease_rad_, 1.0f, 180.0f);
        visitor.real({"line_width_px", "Width of lines."}, line_width_px_, 0.0f, 16.0f);
        visitor.real({"line_presence", "Share of the lines where the object is photoreal."}, line_presence_, 0.0f,
                     1.0f);
        hw::visit_far_lines(visitor, far_);
        lines_.visit_params(visitor);
        ink_look_.visit_params(visitor);
    }

    hw::Needs needs() const override
    {
        hw::Needs needs;
        lines_.add_needs(needs, look(), edges());
        ink_look_.add_needs(needs);
        needs.shadow = hw::ShadowNeed::main_light;
        needs.lightmap = true;
        return needs;
    }

    void prepare(hw::ProgramCache& programs) override
    {
        program_ =
            programs.surface("hybrid.frag", lines_.defines() + "#define TONE_SHADED 1\n#define MATERIAL_COLOUR 1\n");
        lines_.prepare(programs);
    }

    void images(hw::Pass& pass, hw::Items items) override { lines_.images(pass, items); }

    void surfaces(hw::Pass& pass, hw::Items items) override
    {
        gradient_.each(items, [&](const std::optional<hw::Ramp>& rise, hw::Items together) {
            hw::Uniforms uniforms;
            uniforms.set("ink_share", hw::share_uniform(ink_weight_, rise))
                .set("shade", 0.0f)
                .set("ink_fade", glm::vec4(0.0f));
            ink_look_.set_uniforms(uniforms, tint_);
            lines_.set_uniforms(uniforms.set("line_presence", line_presence_), pass, look(), edges());
            pass.surfaces(program_, uniforms, together);
        });
    }

    void lines(hw::Pass& pass, hw::Items items) override
    {
        hw::LineLook look = this->look();
        gradient_.each(items, [&](const std::optional<hw::Ramp>& rise, hw::Items together) {
            look.share.height.reset();
            if (rise && line_presence_ < 1.0f) {
                // Lines are there from where ink begins: a drawing needs its outlines before its hatching.
                const float height_m = rise->to - rise->from;
                look.share.height = hw::Ramp{rise->from - line_presence_ * height_m, rise->to - 0.5f * height_m};
            }
            lines_.draw(pass, look, together);
        });
        lines_.draw_halo(pass, look, edges());
    }

 private:
    hw::EdgeNeed edges() const { return {.crease_rad = crease_rad_}; }

    hw::LineLook look() const
    {
        hw::LineLook look;
        look.all({line_width_px_, ink_});
        look.far = far_;
        return look;
    }

    float ink_weight_ = 1.0f;
    hw::HeightRamp gradient_{hw::HeightRamp::Over::object, {0.25f, 0.75f}};
    glm::vec3 tint_{1.0f}, ink_{0.07f, 0.06f, 0.06f};
    float crease_rad_ = glm::radians(40.0f), line_width_px_ = 1.4f, line_presence_ = 0.0f;
    hw::FarPolicy far_;
    hw::LinesLook lines_{hw::LinesLook::From::object};
    hw::InkLook ink_look_;
    hw::Program program_;
};

}  // namespace

HW_STYLE(hybrid, "Photoreal where known, pen and ink where conjecture, with a gradient between them", Hybrid)
