#pragma once

#include <cstdint>
#include <vector>

#include "hatchway/geometry/mesh_data.hpp"

namespace hw {

/// A flat piece of a mesh: triangles that hang together over shared edges and lie in one plane.
struct PlanarChart {
    std::vector<std::uint32_t> triangles;
    glm::dvec3 normal{0.0, 0.0, 1.0};  ///< Unit.
    glm::dvec3 along{1.0, 0.0, 0.0};   ///< Unit, in the plane: the direction of its longest outer edge.
    double area = 0.0;
};

/// Cuts a mesh into planar charts; each triangle is in exactly one. A chart grows from its largest triangle over edges
/// whose ends have equal positions, as long as the next triangle looks the same way within 0.1 degree and its corners
/// lie within 1e-5 of the mesh's size of the plane of the first. Triangles without area join a neighbour. The same mesh
/// gives the same charts.
std::vector<PlanarChart> planar_charts(const MeshData& mesh);

}  // namespace hw
