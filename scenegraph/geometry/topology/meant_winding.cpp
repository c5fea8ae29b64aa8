#include "hatchway/geometry/topology/meant_winding.hpp"

#include <glm/geometric.hpp>

namespace hw {
namespace {

std::vector<bool> open_components(const RepairedMesh& mesh)
{
    std::vector<bool> result(mesh.component_count, false);
    for_each_edge(mesh.uses, [&](std::span<const DirectedEdge> edge) {
        if (edge.size() == 2) return;
        for (const DirectedEdge& use : edge) result[mesh.face_component[use.face]] = true;
    });
    return result;
}

bool do_normals_agree(const MeshData& mesh, std::uint32_t triangle)
{
    const std::uint32_t* const index = &mesh.indices[3 * std::size_t{triangle}];
    const auto place = [&](int corner) { return glm::dvec3(mesh.positions[index[corner]]); };
    glm::dvec3 sum(0.0);
    for (int i = 0; i < 3; ++i) sum += glm::dvec3(mesh.normals[index[i]]);
    return glm::dot(sum, glm::cross(place(1) - place(0), place(2) - place(0))) > 0.0;
}

}  // namespace

void keep_meant_winding(const MeshData& mesh, RepairedMesh& repaired)
{
    if (!mesh.has_own_normals || repaired.flipped_faces.empty()) return;
    const std::vector<bool> is_open = open_components(repaired);
    const std::size_t kept = std::erase_if(repaired.flipped_faces, [&](std::uint32_t face) {
        const bool is_meant =
            is_open[repaired.face_component[face]] && do_normals_agree(mesh, repaired.face_triangle[face]);
        if (is_meant) std::swap(repaired.faces[face][1], repaired.faces[face][2]);
        return is_meant;
    });
    if (kept != 0) repaired.uses = sorted_directed_edges(repaired.faces);
}

}  // namespace hw
