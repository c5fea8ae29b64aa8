// An image pass: how near what is seen is to the eye.
#include "hatchway/style/style.hpp"

class Nearness final : public hw::ImagePass {
    void visit_params(hw::ParamVisitor& visitor) override
    {
        visitor.real({"far_m", "Where nearness is 0."}, far_m_, 0.1f, 10000.0f);
    }
    hw::Needs needs() const override { return {}; }
    void prepare(hw::ProgramCache& programs) override { program_ = programs.surface("nearness.frag"); }
    hw::Images make(hw::Pass& pass, hw::Items) override
    {
        return pass.render({.outputs = {{.format = hw::PixelFormat::r8}}}, program_,
                           hw::Uniforms().set("far_m", far_m_), pass.opaque_scene());
    }

    float far_m_ = 20.0f;
    hw::Program program_;
};

HW_IMAGE_PASS(nearness, "R: 1 at the eye, 0 from far_m on and where nothing is", Nearness)
