#include "hatchway/geometry/topology/sheets.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "hatchway/geometry/topology/repaired_mesh.hpp"

namespace hw {
namespace {

/// Against the axis that it lies most along; a preference decides what lies evenly between two.
bool looks_down(const glm::dvec3& area)
{
    const glm::dvec3 size = glm::abs(area) * glm::dvec3(1.0, 1.02, 1.01);
    const int axis = size.y >= size.x && size.y >= size.z ? 1 : size.z >= size.x ? 2 : 0;
    return area[axis] < 0.0;
}

}  // namespace

std::vector<std::uint32_t> triangles_of_turned_sheets(const MeshData& mesh)
{
    const RepairedMesh repaired = repair_mesh(weld(mesh), kStitchShare);
    std::vector<bool> is_open(repaired.component_count, false);
    for_each_edge(repaired.uses, [&](std::span<const DirectedEdge> edge) {
        if (edge.size() == 2 && edge[0].is_forward != edge[1].is_forward) return;
        for (const DirectedEdge& use : edge) is_open[repaired.face_component[use.face]] = true;
    });
    std::vector<glm::dvec3> areas(repaired.component_count, glm::dvec3(0.0));
    for (std::uint32_t face = 0; face < repaired.faces.size(); ++face) {
        const auto& [a, b, c] = repaired.faces[face];
        const glm::dvec3 p = repaired.positions[a];
        areas[repaired.face_component[face]] +=
            glm::cross(glm::dvec3(repaired.positions[b]) - p, glm::dvec3(repaired.positions[c]) - p);
    }
    std::vector<std::uint32_t> triangles;
    for (std::uint32_t face = 0; face < repaired.faces.size(); ++face) {
        const std::uint32_t component = repaired.face_component[face];
        const bool is_doubled = !repaired.two_sided_faces.empty() && repaired.two_sided_faces[face];
        if (is_doubled || repaired.face_triangle[face] == kNoFace) continue;
        if (is_open[component] && looks_down(areas[component])) triangles.push_back(repaired.face_triangle[face]);
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

}  // namespace hw
