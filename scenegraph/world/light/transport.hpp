#pragma once

#include <vector>

#include "hatchway/world/light/scene.hpp"

namespace hw {

/// All that shines on a scene, beside emissive materials, and who looks.
struct LightSources {
    std::vector<Light> lights;
    glm::vec3 sky_luminance{0.0f};       ///< cd/m^2, of every direction above the horizon.
    glm::vec3 ground_luminance{0.0f};    ///< cd/m^2, of every direction below it.
    float emission_luminance = 0.0f;     ///< cd/m^2 of a material whose emission is 1.
    float sun_radius_rad = 0.00465f;     ///< Half the angle that a sun fills: how soft its shadows are.
    float lamp_radius_m = 0.05f;         ///< Of point and spot lights.
    std::vector<glm::dvec3> eyes_world;  ///< From where the light is looked at: find_open_backs().
};

/// A place that receives light. Relative to LightScene::origin_world().
struct LightReceiver {
    glm::vec3 position{0.0f};
    glm::vec3 face_normal{0.0f, 1.0f, 0.0f};     ///< Unit, of the triangle.
    glm::vec3 shading_normal{0.0f, 1.0f, 0.0f};  ///< Unit, in the same half space.
};

/// One sample of the light at a place.
struct LightEstimate {
    glm::vec3 illuminance{0.0f};  ///< Lux.
    bool has_met_back = false;    ///< Its first ray met a side that is not drawn: the place may be inside of a solid.
    std::uint32_t rays = 0;       ///< What it cost, at most.
};

struct LightSampleId {
    std::uint32_t index = 0;  ///< Of the sample. Any first 2^k samples of a place are well spread.
    std::uint32_t seed = 0;   ///< Of the place.
};

/// One sample of the illuminance: every sun, point and spot light through one shadow ray to its surface, or, of more
/// than LampChoice::kMostAsked, some that are chosen by what they may give here; emissive triangles by one point
/// chosen by power and by the path itself, weighed against each other; sky and light sent back by matte surfaces along
/// one path of cosine-weighted directions, ended at random when it carries little. Its mean over samples is the
/// illuminance. Depends on the arguments alone. Source: Veach. Robust Monte Carlo Methods for Light Transport
/// Simulation. Stanford 1997, chapters 9 and 10.
LightEstimate sample_light(const LightScene& scene, const LightSources& sources, const LightReceiver& receiver,
                           const LightSampleId& sample);

/// Illuminance of a face that looks at the light, lux, nothing in the way. `to_light` becomes unit, `distance` infinite
/// for a sun. As lighting.glsl has it: the inverse square law, windowed by the range, and a squared cone.
glm::vec3 unshadowed_illuminance(const Light& light, const glm::dvec3& place_world, glm::vec3& to_light,
                                 float& distance);

}  // namespace hw
