#pragma once

#include <vector>

#include "hatchway/core/box.hpp"
#include "hatchway/geometry/mesh_data.hpp"

namespace hw {

struct MeshPiece {
    Box bounds;  ///< Object space.
    std::size_t triangles = 0;
};

/// The parts of a mesh that lie far apart, by many times their own size, or are of very different size: a stray
/// triangle, a plane without end under a house. One part, the whole, for nearly all meshes; none without triangles.
std::vector<MeshPiece> mesh_pieces(const MeshData& mesh);

}  // namespace hw
