#pragma once

#include "hatchway/geometry/mesh_data.hpp"

namespace hw {

/// Whether every component of a mesh is closed and wound alike, after repair_mesh(): its back is the inside of a solid,
/// whatever a material says of it. Many exporters call everything double-sided.
bool is_shell(const MeshData& mesh);

}  // namespace hw
