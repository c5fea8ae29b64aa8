#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hatchway/geometry/surface/surface.hpp"
#include "hatchway/geometry/topology/weld.hpp"

namespace hw {

/// An edge of exactly two faces, before it has a place in the table.
struct InnerEdge {
    Edge edge;
    std::array<std::uint32_t, 2> vertices;
    float fold_rad = 0.0f;
    bool is_artist = false;
};

/// Marks the edges that the artist wants drawn: those named by MeshData::artist_edges, and those folded by more than
/// `least_fold_rad` across which the model's own normals split. A component whose folded edges are split all alike
/// is flat-shaded: that says how it is lit, not where lines are meant, and marks nothing.
/// `position_of_vertex` gives the welded, stitched position of each vertex of the mesh.
void mark_artist_edges(std::vector<InnerEdge>& edges, const Surface& surface, const MeshData& mesh,
                       std::span<const std::uint32_t> position_of_vertex, float least_fold_rad);

}  // namespace hw
