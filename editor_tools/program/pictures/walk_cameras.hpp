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

/// Where a walk begins: at the level's start, else where the whole scene is in view. `aspect`: width over height.
Camera start_camera(const Level& level, const Scene& scene, double aspect);

/// What `render` is to be given for the same view: "--eye X,Y,Z --target X,Y,Z --fov-deg F", or --ortho.
std::string camera_arguments(const Camera& camera);

}  // namespace hw
