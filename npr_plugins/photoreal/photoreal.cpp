// Photoreal: the model as it was made, with textures, lit by the level's lights.
#include "hatchway/style/style.hpp"

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
    }

    hw::Needs needs() const override
    {
        hw::Needs needs;
        needs.lightmap = true;
        needs.shadow = has_shadows_ ? hw::ShadowNeed::main_light : hw::ShadowNeed::none;
        return needs;
    }

    void prepare(hw::ProgramCache& programs) override { program_ = programs.surface("photoreal.frag"); }

    void surfaces(hw::Pass& pass, hw::Items items) override
    {
        hw::Uniforms uniforms;
        uniforms.set("brightness", brightness_).set("saturation", saturation_).set("tint", hw::linear_colour(tint_));
        pass.surfaces(program_, uniforms, items);
    }

 private:
    float brightness_ = 1.0f;
    float saturation_ = 1.0f;
    glm::vec3 tint_{1.0f};
    bool has_shadows_ = true;
    hw::Program program_;
};

}  // namespace

HW_STYLE(photoreal, "Textures, lights, shadow and reflections: the model as it was made", Photoreal)
