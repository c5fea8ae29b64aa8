#pragma once

#include <span>
#include <vector>

#include "hatchway/world/scene.hpp"

namespace hw {

/// For each object whether light and sight reach the back of its faces: its material is double-sided, and its mesh is
/// no shell (geometry/topology/shell.hpp), or a shell in which something shines or somebody looks: a room. Many
/// exporters call everything double-sided, so a shell alone is a solid; what lies dark inside of one, as goods in a
/// crate, is seen by nobody. What shines are the points and spots among `lights`, and objects of materials that emit,
/// by the middle of their bounds; who looks are `eyes_world`.
std::vector<bool> find_open_backs(const Scene& scene, std::span<const Light> lights = {},
                                  std::span<const glm::dvec3> eyes_world = {});

}  // namespace hw
