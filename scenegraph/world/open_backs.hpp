#pragma once

#include <vector>

#include "hatchway/world/scene.hpp"

namespace hw {

/// For each object whether light and sight reach the back of its faces: its material is double-sided, and its mesh is
/// no shell (geometry/topology/shell.hpp).
std::vector<bool> find_open_backs(const Scene& scene);

}  // namespace hw
