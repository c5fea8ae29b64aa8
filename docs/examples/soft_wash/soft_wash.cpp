// A style in two passes: the shade of all its objects at half size, blurred, then laid over each object's colour.
#include "hatchway/style/style.hpp"

class SoftWash final : public hw::Style {
    void visit_params(hw::ParamVisitor& visitor) override
    {
        visitor.real({"softness_px", "How far the shade runs."}, softness_px_, 0.0f, 32.0f);
    }
    hw::Needs needs() const override { return {.shadow = hw::ShadowNeed::main_light}; }
    void prepare(hw::ProgramCache& programs) override
    {
        shade_ = programs.surface("shade.frag");
        blur_ = programs.full_screen("blur.frag");
        wash_ = programs.surface("soft_wash.frag");
    }
    void images(hw::Pass& pass, hw::Items items) override
    {
        const hw::TargetDesc half{.outputs = {{.format = hw::PixelFormat::rg8}}, .scale = 0.5f};
        hw::Image shade = pass.render(half, shade_, {}, items)[0];
        for (const glm::vec2& way : {glm::vec2(1.0f, 0.0f), glm::vec2(0.0f, 1.0f)}) {
            const glm::vec2 step_px = way * softness_px_ * pass.view().px_scale / 4.0f;
            shade = pass.filter(half, blur_, hw::Uniforms().set("source", shade).set("step_px", step_px))[0];
        }
        soft_ = shade;
    }
    void surfaces(hw::Pass& pass, hw::Items items) override
    {
        pass.surfaces(wash_, hw::Uniforms().set("shade", soft_), items);
    }

    float softness_px_ = 8.0f;
    hw::Program shade_, blur_, wash_;
    hw::Image soft_;
};

HW_STYLE(soft_wash, "A wash of soft shade over the colours of the model", SoftWash)
