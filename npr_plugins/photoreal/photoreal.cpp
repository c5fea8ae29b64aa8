// Photoreal: the model as it was made, with textures, lit by the level's lights.
#include "hatchway/kit/lines_look.hpp"

namespace {

class Photoreal final : public hw::Style {
 public:
    void visit_params(hw::ParamVisitor& visitor) override
    {
        visitor.real({"brightness", "Factor on the light that leaves the object."}, brightness_, 0.0f, 8.0f);
        visitor.real({"saturation", "0 shows grays, 1 the model's colours."}, saturation_, 0.0f, 2.0f);
        visitor.colour({"tint", "Colour that is multiplied onto the object: a free variable of the presentation."},
                       tint_);
        visitor.flag({"shadows", "Whether the main light casts shadows on the object.", hw::ParamChange::rebuild},
                     has_shadows_);
        pens_.visit_params(visitor);
        lines_.visit_params(visitor);
    }

    hw::Needs needs() const override
    {
        hw::Needs needs;
        needs.lightmap = true;
        needs.shadow = has_shadows_ ? hw::ShadowNeed::main_light : hw::ShadowNeed::none;
        lines_.add_needs(needs, pens_.look(), pens_.edges());
        return needs;
    }

    void prepare(hw::ProgramCache& programs) override
    {
        program_ = programs.surface("photoreal.frag", lines_.defines());
        lines_.prepare(programs);
    }

    void images(hw::Pass& pass, hw::Items items) override { lines_.images(pass, items); }

    void surfaces(hw::Pass& pass, hw::Items items) override
    {
        hw::Uniforms uniforms;
        uniforms.set("brightness", brightness_).set("saturation", saturation_).set("tint", hw::linear_colour(tint_));
        lines_.set_uniforms(uniforms, pass, pens_.look(), pens_.edges());
        pass.surfaces(program_, uniforms, items);
    }

    void lines(hw::Pass& pass, hw::Items items) override
    {
        lines_.draw(pass, pens_.look(), items);
        lines_.draw_halo(pass, pens_.look(), pens_.edges());
    }

 private:
    float brightness_ = 1.0f;
    float saturation_ = 1.0f;
    glm::vec3 tint_{1.0f};
    bool has_shadows_ = true;
    hw::TwoPens pens_;
    hw::LinesLook lines_{hw::LinesLook::From::none};
    hw::Program program_;
};

}  // namespace

HW_STYLE(photoreal, "Textures, lights, shadow and reflections: the model as it was made", Photoreal)
