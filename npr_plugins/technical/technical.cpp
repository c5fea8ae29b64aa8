// Technical: cool and warm colours say which way a face turns, white and black lines where it ends and folds.
// Sources: Gooch, Gooch, Shirley, Cohen. A Non-Photorealistic Lighting Model for Automatic Technical Illustration.
// SIGGRAPH 1998. Nienhaus, Doellner. Edge-Enhancement. Journal of WSCG 11, 2003, section 5.
#include "hatchway/kit/lines_look.hpp"

namespace {

class Technical final : public hw::Style {
 public:
    void visit_params(hw::ParamVisitor& visitor) override
    {
        visitor.colour({"cool_colour", "Of faces that look away from the light."}, cool_);
        visitor.colour({"warm_colour", "Of faces that look at the light."}, warm_);
        visitor.real({"cool_from_material", "Share of the material's colour in the cool one."}, cool_material_, 0.0f,
                     1.0f);
        visitor.real({"warm_from_material", "Share of the material's colour in the warm one."}, warm_material_, 0.0f,
                     1.0f);
        visitor.angle({"light_right_deg", "Where the light stands, to the right of the viewer."}, light_right_rad_,
                      -180.0f, 180.0f);
        visitor.angle({"light_up_deg", "And how far above the horizon."}, light_up_rad_, -90.0f, 90.0f);
        visitor.real({"highlight", "Strength of the highlight."}, highlight_, 0.0f, 1.0f);
        visitor.real({"shininess", "How narrow the highlight is: the exponent of Phong's model."}, shininess_, 1.0f,
                     500.0f);
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
        program_ = programs.surface("technical.frag", lines_.defines());
        lines_.prepare(programs);
    }

    void images(hw::Pass& pass, hw::Items items) override { lines_.images(pass, items); }

    void surfaces(hw::Pass& pass, hw::Items items) override
    {
        const glm::vec3 to_light(std::sin(light_right_rad_) * std::cos(light_up_rad_), std::sin(light_up_rad_),
                                 std::cos(light_right_rad_) * std::cos(light_up_rad_));
        hw::Uniforms uniforms;
        uniforms.set("cool", glm::vec4(hw::linear_colour(cool_), cool_material_))
            .set("warm", glm::vec4(hw::linear_colour(warm_), warm_material_))
            .set("to_light_view", to_light)
            .set("highlight", glm::vec2(highlight_, shininess_));
        lines_.set_uniforms(uniforms, pass, pens_.look(), pens_.edges());
        pass.surfaces(program_, uniforms, items);
    }

    void lines(hw::Pass& pass, hw::Items items) override
    {
        lines_.draw(pass, pens_.look(), items);
        lines_.draw_halo(pass, pens_.look(), pens_.edges());
    }

 private:
    glm::vec3 cool_{0.35f, 0.45f, 0.62f}, warm_{0.93f, 0.86f, 0.68f};
    float cool_material_ = 0.25f, warm_material_ = 0.5f;
    float light_right_rad_ = glm::radians(-40.0f), light_up_rad_ = glm::radians(45.0f);
    float highlight_ = 0.5f, shininess_ = 40.0f;
    hw::TwoPens pens_{.profile_width_px = 2.0f, .inner_width_px = 1.2f, .inner_colour = glm::vec3(1.0f)};
    hw::LinesLook lines_{hw::LinesLook::From::edge_map};
    hw::Program program_;
};

}  // namespace

HW_STYLE(technical, "Cool-to-warm shading with a highlight, white creases and black profiles", Technical)
