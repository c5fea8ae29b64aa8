#pragma once

#include <glm/vec3.hpp>

#include "hatchway/world/visibility/tree/bsp.hpp"

namespace hw::measure {

/// The leaf of a point by walking the tree with rational arithmetic on the planes' whole numbers: the exact sign of the
/// point at every plane it passes. -1 outside of the box.
int leaf_by_rationals(const BspTree& tree, const glm::dvec3& point_world);

}  // namespace hw::measure
