// Halftone: one ink, thresholded by tone over a texture of priorities, as printers do, and lines.
// Source: Freudenberg, Masuch, Strothotte. Real-Time Halftoning: A Primitive For Non-Photorealistic Shading.
// Eurographics Workshop on Rendering 2002.
#include "hatchway/kit/lines_look.hpp"

namespace {

enum class Screen { dots, strokes };
constexpr std::array<std::string_view, 2> kScreens{"dots", "strokes"};

class Halftone final : public hw::Style {
 public:
    void visit_params(hw::ParamVisitor& visitor) override
    {
        using enum hw::ParamChange;
        visitor.choice({"screen",
                        "What lies on what: dots of an image on the picture, or strokes of a tonal map on the "
                        "objects.",
                        rebuild},
                       screen_, kScreens);
        visitor.image(
            {"priorities", "Of dots: an image whose grays are spread evenly and that repeats; white takes ink first.",
             rebuild},
            priorities_);
        visitor.map({"tonal", "Of strokes: a tonal map of one tone.", rebuild}, tonal_, hw::MapKind::tonal);
        visitor.real({"spacing_px", "From one dot to the next."}, spacing_px_, 3.0f, 64.0f);
        visitor.angle({"screen_deg", "How the rows of dots are turned."}, turn_rad_, -90.0f, 90.0f);
        visitor.real({"darkness", "Ink coverage of the darkest shadow."}, darkness_, 0.0f, 1.0f);
        visitor.real({"white_from", "Light above which paper stays white."}, white_from_, 0.05f, 1.0f);
        visitor.real({"material_tone", "How much dark materials darken the tone."}, material_tone_, 0.0f, 1.0f);
        visitor.colour({"paper_colour", "Colour of faces."}, paper_);
        visitor.colour({"ink_colour", "Colour of dots and strokes."}, ink_);
        visitor.real({"paper_from_material", "Share of the material's colour in the paper's."}, paper_material_, 0.0f,
                     1.0f);
        pens_.visit_params(visitor);
        lines_.visit_params(visitor);
    }

    hw::Needs needs() const override
    {
        hw::Needs needs;
        needs.shadow = hw::ShadowNeed::main_light;
        needs.lightmap = true;
        needs.streams.hatch_uv = screen_ == Screen::strokes;
        if (screen_ == Screen::strokes) needs.maps[hw::MapKind::tonal] = tonal_;
        lines_.add_needs(needs, pens_.look(), pens_.edges());
        return needs;
    }

    void prepare(hw::ProgramCache& programs) override
    {
        const bool is_dots = screen_ == Screen::dots;
        program_ = programs.surface("halftone.frag", lines_.defines() + (is_dots ? "#define SCREEN_OF_DOTS 1\n" : ""));
        lines_.prepare(programs);
        if (is_dots) texture_ = programs.texture(priorities_.value);
    }

    void images(hw::Pass& pass, hw::Items items) override { lines_.images(pass, items); }

    void surfaces(hw::Pass& pass, hw::Items items) override
    {
        hw::Uniforms uniforms;
        uniforms.set("tone_range", glm::vec3(darkness_, white_from_, material_tone_))
            .set("paper", glm::vec4(hw::linear_colour(paper_), paper_material_))
            .set("ink_colour", hw::linear_colour(ink_));
        if (screen_ == Screen::dots)
            uniforms.set("priorities", texture_)
                .set("rows", glm::vec3(std::cos(turn_rad_), std::sin(turn_rad_), spacing_px_));
        lines_.set_uniforms(uniforms, pass, pens_.look(), pens_.edges());
        pass.surfaces(program_, uniforms, items);
    }

    void lines(hw::Pass& pass, hw::Items items) override
    {
        lines_.draw(pass, pens_.look(), items);
        lines_.draw_halo(pass, pens_.look(), pens_.edges());
    }

 private:
    Screen screen_ = Screen::dots;
    hw::ImageFile priorities_{"screen/dots.png"};
    hw::MapName tonal_{"halftone"};
    float spacing_px_ = 5.0f, turn_rad_ = glm::radians(45.0f);
    float darkness_ = 0.8f, white_from_ = 0.8f, material_tone_ = 0.3f, paper_material_ = 0.0f;
    glm::vec3 paper_{1.0f}, ink_{0.33f, 0.34f, 0.38f};
    hw::TwoPens pens_;
    hw::LinesLook lines_{hw::LinesLook::From::edge_map};
    hw::Program program_;
    hw::Image texture_;
};

}  // namespace

HW_STYLE(halftone, "One ink in printed dots or strokes by light and shadow, and lines", Halftone)
