#pragma once

#include "hatchway/world/scene.hpp"

namespace hw {

/// What every model gets, whatever its format: triangles that wind against the rest of their component are turned over
/// (topology/mesh_faults.hpp), so that nobody culls or lights them from the wrong side; what is shown from both sides
/// has no triangle twice, and its sheets all wind the same way; and meshes whose vertices lie far from their origin are
/// moved to it, exactly, so that floats suffice wherever they go. Their objects stay where they are.
void settle_meshes(Scene& scene);

}  // namespace hw
