#pragma once

#include <array>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "hatchway/style/style.hpp"

namespace hw {

/// How surfaces are drawn in ink, for styles whose shader includes ink.glsl: parameters, needs and uniforms in one
/// place, so that every style in ink has the same controls. Lengths are logical pixels, colours sRGB.
struct InkLook {
    HatchSource hatch_source = HatchSource::model;
    float spacing_px = 4.5f, stroke_width_px = 0.8f, stroke_length_px = 170.0f, wobble_px = 0.4f;
    float hatch_deg = 52.0f, cross_deg = 70.0f;  ///< Degrees: their sum is a direction, and 52 + 70 is exact.
    float darkness = 0.66f, white_from = 0.72f, shadow_below = 0.26f;
    float material_tone = 0.1f, light_response = 1.0f;
    glm::vec3 hatch_colour{0.24f, 0.22f, 0.21f}, uncertain_colour{1.0f};
    float paper_from_material = 0.0f, ink_from_material = 0.0f;
    float ink_map_strength = 1.0f, ink_map_detail = 0.2f;

    /// Whether the program wants the define MATERIAL_COLOUR.
    bool has_material_colour() const { return paper_from_material > 0.0f || ink_from_material > 0.0f; }

    void visit_params(ParamVisitor& visitor);
    void add_needs(Needs& needs) const;

    /// All uniforms of ink.glsl but `shade` and `ink_fade`. `paper` is sRGB, of objects of certainty 1.
    void set_uniforms(Uniforms& uniforms, const glm::vec3& paper) const;
};

inline void InkLook::visit_params(ParamVisitor& visitor)
{
    static constexpr std::array<std::string_view, 4> kSources{"model", "box", "cylinder", "principal"};
    visitor.real({"spacing_px", "Between hatching strokes."}, spacing_px, 2.0f, 64.0f);
    visitor.real({"stroke_width_px", "Width of hatching strokes."}, stroke_width_px, 0.2f, 16.0f);
    visitor.choice({"hatch_direction",
                    "What strokes follow: the model's texture coordinates (a box where it has none), a box, a "
                    "cylinder, or the direction of strongest curvature.",
                    ParamChange::rebuild},
                   hatch_source, kSources);
    visitor.real({"hatch_deg", "Direction of the first hatching; 0 is level on walls."}, hatch_deg, -90.0f, 90.0f);
    visitor.real({"cross_deg", "From the first direction to the one that crosses it."}, cross_deg, 10.0f, 90.0f);
    visitor.real({"stroke_length_px", "Mean length of strokes; 0 rules endless lines."}, stroke_length_px, 0.0f,
                 1000.0f);
    visitor.real({"wobble_px", "How far a stroke strays sideways."}, wobble_px, 0.0f, 4.0f);
    visitor.real({"darkness", "Ink coverage of the darkest shadow."}, darkness, 0.0f, 1.0f);
    visitor.real({"white_from", "Light above which paper stays white."}, white_from, 0.05f, 1.0f);
    visitor.real({"shadow_below", "Light below which hatching is darkest."}, shadow_below, 0.0f, 0.95f);
    visitor.real({"material_tone", "How much dark materials darken the hatching."}, material_tone, 0.0f, 1.0f);
    visitor.real({"light_response", "How much light and shadow change the tone; 0 hatches evenly, half dark."},
                 light_response, 0.0f, 1.0f);
    visitor.colour(
        {"hatch_colour", "Colour of hatching and of ink maps: a little softer than lines, it stays behind them."},
        hatch_colour);
    visitor.colour({"uncertain_colour", "Paper of objects of certainty 0; certainty 1 has the style's own."},
                   uncertain_colour);
    visitor.real({"paper_from_material", "Share of the material's colour in the paper's.", ParamChange::rebuild},
                 paper_from_material, 0.0f, 1.0f);
    visitor.real({"ink_from_material", "Share of the material's colour in the hatching's.", ParamChange::rebuild},
                 ink_from_material, 0.0f, 1.0f);
    visitor.real({"ink_map_strength", "Of the ink map; 0 hides it."}, ink_map_strength, 0.0f, 1.0f);
    visitor.real({"ink_map_detail", "Levels of the ink map by which it is drawn finer: more and thinner strokes."},
                 ink_map_detail, -2.0f, 2.0f);
}

inline void InkLook::add_needs(Needs& needs) const
{
    needs.streams.hatch_uv = true;
    needs.streams.hatch_source = hatch_source;
}

inline void InkLook::set_uniforms(Uniforms& uniforms, const glm::vec3& paper) const
{
    const auto direction = [](float angle_deg) {
        return glm::vec2(std::cos(glm::radians(angle_deg)), std::sin(glm::radians(angle_deg)));
    };
    uniforms.set("hatch_size_px", glm::vec4(spacing_px, stroke_width_px, stroke_length_px, wobble_px))
        .set("hatch_directions", glm::vec4(direction(hatch_deg), direction(hatch_deg + cross_deg)))
        .set("tone_range", glm::vec4(darkness, white_from, shadow_below, material_tone))
        .set("paper_colour", linear_colour(paper))
        .set("ink_colour", linear_colour(hatch_colour))
        .set("uncertain_colour", linear_colour(uncertain_colour))
        .set("from_material", glm::vec2(paper_from_material, ink_from_material))
        .set("light_response", light_response)
        .set("ink_map_look", glm::vec2(ink_map_strength, ink_map_detail));
}

}  // namespace hw
