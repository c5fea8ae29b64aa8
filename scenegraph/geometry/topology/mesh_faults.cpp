#include "hatchway/geometry/topology/mesh_faults.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "hatchway/geometry/topology/meant_winding.hpp"
#include "hatchway/geometry/topology/repaired_mesh.hpp"

namespace hw {
namespace {

/// Most meshes are closed and wound alike, which a look at their edges tells.
bool is_closed_and_consistent(const WeldedMesh& mesh)
{
    bool is_good = true;
    for_each_edge(sorted_directed_edges(mesh.faces), [&](std::span<const DirectedEdge> edge) {
        is_good &= edge.size() == 2 && edge[0].is_forward != edge[1].is_forward;
    });
    return is_good;
}

/// Marks the component of each face of the edges of which `is_open` says so.
template <typename IsOpen>
std::vector<bool> components_with(const RepairedMesh& mesh, IsOpen&& is_open)
{
    std::vector<bool> result(mesh.component_count, false);
    for_each_edge(mesh.uses, [&](std::span<const DirectedEdge> edge) {
        if (!is_open(edge)) return;
        for (const DirectedEdge& use : edge) result[mesh.face_component[use.face]] = true;
    });
    return result;
}

/// Along the normal that the winding gives, twice as long as the area.
glm::dvec3 area_of(const MeshData& mesh, std::uint32_t triangle)
{
    const auto place = [&](std::size_t corner) {
        return glm::dvec3(mesh.positions[mesh.indices[3 * std::size_t{triangle} + corner]]);
    };
    return glm::cross(place(1) - place(0), place(2) - place(0));
}

std::vector<std::uint32_t> wrongly_wound(const RepairedMesh& repaired)
{
    std::vector<std::uint32_t> triangles;
    for (const std::uint32_t face : repaired.flipped_faces) triangles.push_back(repaired.face_triangle[face]);
    return triangles;
}

/// Against the axis that it lies most along; a preference decides what lies evenly between two.
bool looks_down(const glm::dvec3& area)
{
    const glm::dvec3 size = glm::abs(area) * glm::dvec3(1.0, 1.02, 1.01);
    const int axis = size.y >= size.x && size.y >= size.z ? 1 : size.z >= size.x ? 2 : 0;
    return area[axis] < 0.0;
}

std::vector<std::uint32_t> of_turned_sheets(const RepairedMesh& repaired)
{
    const std::vector<bool> is_open = components_with(
        repaired, [](const auto& edge) { return edge.size() != 2 || edge[0].is_forward == edge[1].is_forward; });
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
    return triangles;
}

}  // namespace

MeshFaults find_mesh_faults(const MeshData& mesh)
{
    WeldedMesh welded = weld(mesh);
    if (is_closed_and_consistent(welded)) return {};
    RepairedMesh repaired = repair_mesh(std::move(welded), kStitchShare);
    MeshFaults faults{{}, of_turned_sheets(repaired), repaired.doubled_triangles};
    keep_meant_winding(mesh, repaired);
    faults.wrongly_wound = wrongly_wound(repaired);
    for (auto* triangles : {&faults.wrongly_wound, &faults.of_turned_sheets, &faults.doubled})
        std::sort(triangles->begin(), triangles->end());
    return faults;
}

void turn_over(MeshData& mesh, const std::vector<std::uint32_t>& triangles)
{
    for (const std::uint32_t triangle : triangles)
        std::swap(mesh.indices[3 * std::size_t{triangle} + 1], mesh.indices[3 * std::size_t{triangle} + 2]);
    if (triangles.empty() || mesh.normals.empty()) return;
    std::vector<bool> is_kept(mesh.positions.size(), false);  // also used by another triangle
    auto next = triangles.begin();
    for (std::uint32_t triangle = 0; triangle < mesh.triangle_count(); ++triangle) {
        if (next != triangles.end() && *next == triangle) {
            ++next;
            continue;
        }
        for (std::size_t i = 0; i < 3; ++i) is_kept[mesh.indices[3 * std::size_t{triangle} + i]] = true;
    }
    for (const std::uint32_t triangle : triangles) {
        const std::uint32_t* const corner = &mesh.indices[3 * std::size_t{triangle}];
        const glm::dvec3 area = area_of(mesh, triangle);
        for (int i = 0; i < 3; ++i)
            if (!is_kept[corner[i]] && glm::dot(glm::dvec3(mesh.normals[corner[i]]), area) < 0.0)
                mesh.normals[corner[i]] = -mesh.normals[corner[i]];
    }
}

void leave_out(MeshData& mesh, const std::vector<std::uint32_t>& triangles)
{
    auto next = triangles.begin();
    std::size_t kept = 0;
    for (std::uint32_t triangle = 0; triangle < mesh.triangle_count(); ++triangle) {
        if (next != triangles.end() && *next == triangle) {
            ++next;
            continue;
        }
        for (std::size_t i = 0; i < 3; ++i) mesh.indices[kept++] = mesh.indices[3 * std::size_t{triangle} + i];
    }
    mesh.indices.resize(kept);
}

}  // namespace hw
