#pragma once

#include "hatchway/geometry/mesh_data.hpp"
#include "hatchway/geometry/topology/repaired_mesh.hpp"

namespace hw {

/// Turns back what repair turned over though the model means it: triangles in open components whose own normals look
/// where their winding does. Levels are full of walls that meet back to front. `flipped_faces` loses them; edges to
/// their neighbours become inconsistent. `repaired` is of `mesh`.
void keep_meant_winding(const MeshData& mesh, RepairedMesh& repaired);

}  // namespace hw
