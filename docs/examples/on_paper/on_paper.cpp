// A style with a texture of its own: the model's colours, printed on grainy paper.
#include "hatchway/style/style.hpp"

class OnPaper final : public hw::Style {
    void visit_params(hw::ParamVisitor& visitor) override
    {
        visitor.image({"paper", "The paper: a gray image that repeats.", hw::ParamChange::rebuild}, paper_);
        visitor.real({"grain", "How much of it shows."}, grain_, 0.0f, 1.0f);
    }
    hw::Needs needs() const override { return {}; }
    void prepare(hw::ProgramCache& programs) override
    {
        program_ = programs.surface("on_paper.frag");
        texture_ = programs.texture(paper_.value);
    }
    void surfaces(hw::Pass& pass, hw::Items items) override
    {
        pass.surfaces(program_, hw::Uniforms().set("paper", texture_).set("grain", grain_), items);
    }

    hw::ImageFile paper_{"paper.png"};
    float grain_ = 0.5f;
    hw::Program program_;
    hw::Image texture_;
};

HW_STYLE(on_paper, "The model's colours on grainy paper", OnPaper)
