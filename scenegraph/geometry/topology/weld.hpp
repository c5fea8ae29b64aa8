#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hatchway/geometry/mesh_data.hpp"

namespace hw {

/// The topology of a mesh: every position once.
struct WeldedMesh {
    std::vector<glm::vec3> positions;                 ///< In the order of first use by a triangle; no two are equal.
    std::vector<std::uint32_t> vertex_position;       ///< For each vertex of the MeshData; unused vertices 0.
    std::vector<std::array<std::uint32_t, 3>> faces;  ///< Triangles of three different positions.
    std::vector<std::uint32_t> face_triangle;         ///< Where each came from.
};

/// Joins vertices of exactly equal position (0 and -0 are equal) and leaves out triangles with two equal corners.
WeldedMesh weld(const MeshData& mesh);

}  // namespace hw
