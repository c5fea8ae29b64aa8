#pragma once

#include <cstdint>
#include <vector>

#include "hatchway/core/box.hpp"
#include "hatchway/geometry/mesh_data.hpp"

namespace hw {

/// A run of a mesh's triangles that is hidden or drawn as one.
struct MeshChunk {
    std::uint32_t first_index = 0;  ///< Into MeshData::indices.
    std::uint32_t index_count = 0;  ///< Three per triangle.
    Box bounds_object;
};

/// The chunks of one mesh, in the order of its indices; together they are all of its triangles, each once.
using MeshChunks = std::vector<MeshChunk>;

/// A mesh of at most this many triangles is one chunk.
inline constexpr std::uint32_t kMaxChunkTriangles = 256;

/// Reorders the triangles of `mesh` (never their corners, never the vertices) so that near ones stand together, and
/// cuts them into chunks of at most kMaxChunkTriangles. A small mesh keeps its order and is one chunk; an empty one has
/// none. The same mesh gives the same order. Method: halving at the median of the centres along the longest side.
MeshChunks split_into_chunks(MeshData& mesh);

}  // namespace hw
