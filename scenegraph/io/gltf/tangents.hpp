#pragma once

#include "hatchway/geometry/mesh_data.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// Makes tangents from the texture coordinates that `use` samples, where the mesh has none. Vertices on the seam of a
/// mirrored texture are doubled. Does nothing to a mesh without those coordinates.
void add_tangents(MeshData& mesh, const TextureUse& use);

}  // namespace hw
