#pragma once

#include <string>
#include <vector>

#include "hatchway/world/level.hpp"

namespace hw {

/// Level cameras in the order of their file, then the model's: what the digits 1..9 go to.
std::vector<Camera> walk_cameras(const Level& level, const Scene& scene);

/// Throws hw::Error that lists them when there is none of that name; `instead` is what is expected where there are none
/// at all.
Camera camera_named(const std::string& name, const Level& level, const Scene& scene, const std::string& instead);

}  // namespace hw
