#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "hatchway/world/visibility/rows/slot_rows.hpp"

namespace hw {

/// A triangle of a slot where it is drawn.
struct SlotTriangle {
    std::array<glm::dvec3, 3> corners_world;
    double facing_sign = 1.0;  ///< Of the normal that points to the side from which it is drawn; 0: drawn from both.
};
std::vector<SlotTriangle> slot_triangles(const SlotPlaces& places, std::uint32_t slot);

/// How far a drawn triangle may lie from its snapped copy in the tree, and a little; metres.
double slack_m(const Grid& grid);

}  // namespace hw
