#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace hw {

/// Up in a picture, of unit length and across the line of sight, of a camera that looks along the unit vector
/// `direction`, world space. Without `roll_rad` that is towards +y; straight up or down, where nothing is, +z or -z:
/// the limit of tilting the head. The roll turns the camera about its line of sight, counter-clockwise as it looks: its
/// top leans to its left, and what it shows turns clockwise.
inline glm::dvec3 picture_up(const glm::dvec3& direction, double roll_rad)
{
    const bool is_vertical = std::abs(direction.y) > 0.999999;
    const glm::dvec3 upward =
        is_vertical ? glm::dvec3(0.0, 0.0, direction.y > 0.0 ? 1.0 : -1.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 right = glm::normalize(glm::cross(direction, upward));
    const glm::dvec3 up = glm::cross(right, direction);
    return roll_rad == 0.0 ? up : std::cos(roll_rad) * up - std::sin(roll_rad) * right;
}

}  // namespace hw
