#include "hatchway/geometry/topology/shell.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "hatchway/geometry/topology/repaired_mesh.hpp"

namespace hw {

bool is_shell(const MeshData& mesh)
{
    const RepairedMesh repaired = repair_mesh(weld(mesh), kStitchShare);
    const auto& two_sided = repaired.two_sided_faces;
    bool is_closed = !repaired.uses.empty() && std::find(two_sided.begin(), two_sided.end(), true) == two_sided.end();
    for_each_edge(repaired.uses, [&](std::span<const DirectedEdge> edge) {
        is_closed &= edge.size() == 2 && edge[0].is_forward != edge[1].is_forward;
    });
    return is_closed;
}

bool is_within_shell(const MeshData& mesh, const glm::dvec3& point)
{
    double half_angles = 0.0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = glm::dvec3(mesh.positions[mesh.indices[i]]) - point;
        const glm::dvec3 b = glm::dvec3(mesh.positions[mesh.indices[i + 1]]) - point;
        const glm::dvec3 c = glm::dvec3(mesh.positions[mesh.indices[i + 2]]) - point;
        const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
        half_angles += std::atan2(glm::dot(a, glm::cross(b, c)),
                                  la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    }
    return std::abs(half_angles) > glm::pi<double>();  // of 2 pi inside, 0 outside
}

}  // namespace hw
