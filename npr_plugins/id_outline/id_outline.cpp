// Outlines alone, by the numbers of triangles: nothing is known of the model but where the corners of its triangles
// are. Source: Diktas, Sahiner. ID-Based Rendering of Silhouettes on GPU. 2011.
#include "hatchway/kit/lines_look.hpp"

namespace {

class IdOutline final : public hw::Style {
 public:
    void visit_params(hw::ParamVisitor& visitor) override
    {
        visitor.colour({"paper_colour", "Colour of faces."}, paper_);
        visitor.real({"paper_from_material", "Share of the material's colour in it."}, from_material_, 0.0f, 1.0f);
        pens_.visit_params(visitor);
        lines_.visit_params(visitor);
    }

    hw::Needs needs() const override
    {
        hw::Needs needs;
        lines_.add_needs(needs, pens_.look(), pens_.edges());
        return needs;
    }

    void prepare(hw::ProgramCache& programs) override
    {
        program_ = programs.surface("id_outline.frag", lines_.defines());
        lines_.prepare(programs);
    }

    void images(hw::Pass& pass, hw::Items items) override { lines_.images(pass, items); }

    void surfaces(hw::Pass& pass, hw::Items items) override
    {
        hw::Uniforms uniforms;
        uniforms.set("paper", glm::vec4(hw::linear_colour(paper_), from_material_));
        lines_.set_uniforms(uniforms, pass, pens_.look(), pens_.edges());
        pass.surfaces(program_, uniforms, items);
    }

    void lines(hw::Pass& pass, hw::Items items) override
    {
        lines_.draw(pass, pens_.look(), items);
        lines_.draw_halo(pass, pens_.look(), pens_.edges());
    }

 private:
    glm::vec3 paper_{1.0f};
    float from_material_ = 0.0f;
    hw::TwoPens pens_;
    hw::LinesLook lines_{hw::LinesLook::From::ids};
    hw::Program program_;
};

}  // namespace

HW_STYLE(id_outline, "Paper and outlines, found by numbers of triangles without any preparation of the model",
         IdOutline)
