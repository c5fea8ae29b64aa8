#pragma once

#include "hatchway/geometry/mesh_data.hpp"

namespace hw {

/// Whether every component of a mesh is closed and wound alike, after repair_mesh(): its back is the inside of a solid,
/// whatever a material says of it. Many exporters call everything double-sided.
bool is_shell(const MeshData& mesh);

/// Whether a point, object space, lies inside of a shell: from there its faces fill all directions.
/// Source: Van Oosterom, Strackee. The Solid Angle of a Plane Triangle. 1983.
bool is_within_shell(const MeshData& mesh, const glm::dvec3& point);

}  // namespace hw
