#pragma once

#include "hatchway/render/view/camera_view.hpp"
#include "hatchway/world/level.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// The camera from the front, the right and above that sees the whole scene as near as the picture allows, its outline
/// in the middle; what lies far away from all else, or is far larger, does not count (find_places()). `aspect` is the
/// picture's width / height. An empty scene gives a camera that looks at the origin.
CameraPlace whole_scene_camera(const Scene& scene, double aspect);

/// A path once around the scene in 10 s, ending where it begins, always as far away as the widest view of the turn
/// needs.
CameraPath turntable(const Scene& scene, double aspect);

}  // namespace hw
