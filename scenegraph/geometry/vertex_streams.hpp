#pragma once

#include "hatchway/geometry/mesh_data.hpp"

namespace hw {

/// Calls `visit(stream)` for each stream of a mesh that has a value for each vertex, empty ones too. `Mesh` is MeshData
/// or const MeshData. Who copies or reorders vertices goes by this list.
template <typename Mesh, typename Visit>
void for_each_stream(Mesh& mesh, Visit&& visit)
{
    visit(mesh.positions);
    visit(mesh.normals);
    visit(mesh.tangents);
    visit(mesh.uv0);
    visit(mesh.uv1);
    visit(mesh.lightmap_uv);
    visit(mesh.colours);
}

}  // namespace hw
