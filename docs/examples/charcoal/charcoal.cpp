// A style with a pen of its own: white paper, and lines that crumble like charcoal.
#include "hatchway/style/style.hpp"

class Charcoal final : public hw::Style {
    void visit_params(hw::ParamVisitor& visitor) override
    {
        visitor.real({"width_px", "Width of all lines."}, width_px_, 1.0f, 32.0f);
        visitor.real({"grain_m", "Size of the grain along a line, on the object."}, grain_m_, 0.001f, 10.0f);
    }
    hw::Needs needs() const override { return {.edges = hw::EdgeNeed{}}; }
    void prepare(hw::ProgramCache& programs) override
    {
        paper_ = programs.surface("paper.frag");
        pen_ = programs.line("charcoal.frag");
    }
    void surfaces(hw::Pass& pass, hw::Items items) override { pass.surfaces(paper_, {}, items); }
    void lines(hw::Pass& pass, hw::Items items) override
    {
        hw::LineLook look;
        look.all({.width_px = width_px_, .colour = glm::vec3(0.1f)});
        look.stroke.wobble_px = 1.0f;
        pass.lines(pen_, hw::Uniforms().set("grain_m", grain_m_), look, items);
    }

    float width_px_ = 5.0f;
    float grain_m_ = 0.05f;
    hw::Program paper_, pen_;
};

HW_STYLE(charcoal, "White paper and lines of charcoal", Charcoal)
