#pragma once

#include "core/box.hpp"
#include "world/level.hpp"

namespace hw {

/// A path once around the box in 10 s, always as far away as the widest view
/// of the turn needs. `aspect` is the picture's width / height.
CameraPath turntable(const Box& bounds_world, double aspect);

}  // namespace hw
