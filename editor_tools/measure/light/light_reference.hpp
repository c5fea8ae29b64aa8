#pragma once

#include <glm/vec3.hpp>
#include <span>

namespace hw {

// Closed forms of the light on a matte surface, in double precision. They know nothing of how light is baked.

/// Lux from a point of `candela` at `lamp`.
double point_illuminance(double candela, const glm::dvec3& lamp, const glm::dvec3& place, const glm::dvec3& normal);

/// Lux from a flat, evenly bright polygon of `luminance` (cd/m^2) that lies wholly on the bright side of the place's
/// horizon. Its corners run counter-clockwise as seen from the place.
/// Source: Lambert. Photometria, 1760; as in Baum et al. Improving Radiosity Solutions Through the Use of Analytically
/// Determined Form-Factors. SIGGRAPH 1989, section 3.
double polygon_illuminance(double luminance, std::span<const glm::dvec3> corners, const glm::dvec3& place,
                           const glm::dvec3& normal);

/// Lux everywhere inside of a closed room whose walls shine with `luminance` and send back the share `albedo`.
double closed_room_illuminance(double luminance, double albedo);

}  // namespace hw
