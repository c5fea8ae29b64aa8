#pragma once

#include "hatchway/world/level.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// The view at time `t_s` of a path, clamped to its first and last key. Catmull-Rom in position (tangents by the times
/// of the neighbouring keys), slerp in direction, so that the eye turns evenly; the target lies as far away as the keys
/// say. Where two directions are opposite the turn goes through the horizon. `path` has at least one key.
Camera camera_at(const CameraPath& path, double t_s);

/// Frames of the path: one at its first key, then one every 1/fps until its last: fps * duration + 1.
int path_frame_count(const CameraPath& path);

/// The time of a frame, to be given to camera_at().
double path_frame_time(const CameraPath& path, int frame);

}  // namespace hw
