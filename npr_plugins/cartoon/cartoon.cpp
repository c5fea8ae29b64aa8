// Cartoon: light in few bands of colour, and lines.
// Sources: Lake, Marshall, Harris, Blackstein. Stylized Rendering Techniques for Scalable Real-Time 3D Animation. NPAR
// 2000. Nienhaus, Doellner. Edge-Enhancement. Journal of WSCG 11, 2003, section 5, for bands that are smoothed in the
// picture.
#include "hatchway/kit/lines_look.hpp"

namespace {

enum class Smoothing { none, analytic, map };
constexpr std::array<std::string_view, 3> kSmoothings{"none", "analytic", "map"};

class Cartoon final : public hw::Style {
 public:
    void visit_params(hw::ParamVisitor& visitor) override
    {
        visitor.whole({"bands", "From shadow to light."}, bands_, 2, 8);
        visitor.real({"dark_from", "Light up to which the darkest band goes."}, dark_from_, 0.0f, 1.0f);
        visitor.real({"light_from", "Light from which on the lightest band begins."}, light_from_, 0.0f, 1.0f);
        visitor.colour({"shadow_colour", "What the material's colour is multiplied by in the darkest band."}, shadow_);
        visitor.real({"texture", "How much of the material's texture shows; 0 has its mean colour."}, texture_, 0.0f,
                     1.0f);
        visitor.choice({"smoothing",
                        "Of the steps between bands: none, a step one pixel wide, or of the picture by its neighbours.",
                        hw::ParamChange::rebuild},
                       smoothing_, kSmoothings);
        pens_.visit_params(visitor);
        lines_.visit_params(visitor);
    }

    hw::Needs needs() const override
    {
        hw::Needs needs;
        needs.shadow = hw::ShadowNeed::main_light;
        needs.lightmap = true;
        lines_.add_needs(needs, pens_.look(), pens_.edges());
        return needs;
    }

    void prepare(hw::ProgramCache& programs) override
    {
        const std::string step = smoothing_ == Smoothing::analytic ? "#define SMOOTH_STEPS 1\n" : "";
        const std::string shown = smoothing_ == Smoothing::map ? "#define FROM_CARTOON_MAP 1\n" : step;
        program_ = programs.surface("cartoon.frag", lines_.defines() + shown);
        lines_.prepare(programs);
        if (smoothing_ != Smoothing::map) return;
        hard_ = programs.surface("cartoon.frag", "#define INTO_CARTOON_MAP 1\n");
        smooth_ = programs.full_screen("cartoon_map.frag");
    }

    void images(hw::Pass& pass, hw::Items items) override
    {
        lines_.images(pass, items);
        if (smoothing_ != Smoothing::map) return;
        const hw::TargetDesc target{.outputs = {{.filter = hw::PixelFilter::nearest}}, .depth = hw::TargetDepth::scene};
        const hw::Image hard = pass.render(target, hard_, bands(), items)[0];
        cartoon_map_ = pass.filter(target, smooth_, hw::Uniforms().set("hard", hard))[0];
    }

    void surfaces(hw::Pass& pass, hw::Items items) override
    {
        hw::Uniforms uniforms =
            smoothing_ == Smoothing::map ? hw::Uniforms().set("cartoon_map", cartoon_map_) : bands();
        lines_.set_uniforms(uniforms, pass, pens_.look(), pens_.edges());
        pass.surfaces(program_, uniforms, items);
    }

    void lines(hw::Pass& pass, hw::Items items) override
    {
        lines_.draw(pass, pens_.look(), items);
        lines_.draw_halo(pass, pens_.look(), pens_.edges());
    }

 private:
    hw::Uniforms bands() const
    {
        return hw::Uniforms()
            .set("bands", glm::vec3(bands_, dark_from_, light_from_))
            .set("shadow_colour", hw::linear_colour(shadow_))
            .set("texture_share", texture_);
    }

    int bands_ = 3;
    float dark_from_ = 0.15f, light_from_ = 0.75f, texture_ = 0.0f;
    glm::vec3 shadow_{0.45f, 0.42f, 0.55f};
    Smoothing smoothing_ = Smoothing::analytic;
    hw::TwoPens pens_{.profile_width_px = 2.5f, .inner_width_px = 1.5f};
    hw::LinesLook lines_{hw::LinesLook::From::edge_map};
    hw::Program program_, hard_, smooth_;
    hw::Image cartoon_map_;
};

}  // namespace

HW_STYLE(cartoon, "Light in bands of the material's colour or of its ramp, and lines", Cartoon)
