#pragma once

#include <cstdint>
#include <vector>

#include "hatchway/io/gltf/mesh.hpp"

namespace hw {

/// EXT_mesh_primitive_edge_visibility (draft): the edges that the artist wants drawn, as pairs of vertex indices of the
/// converted mesh. Two bits for each edge of each triangle, in the order 0-1, 1-2, 2-0; the value 2 marks an edge, 3
/// repeats one for its other triangle. Empty without the extension and for strips and fans, which it does not cover.
/// Throws hw::Error when its accessor is too short. Private to io.
std::vector<std::uint32_t> artist_edges(const GltfModel& model, const PrimitiveId& id, const MeshData& mesh);

}  // namespace hw
