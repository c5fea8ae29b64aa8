#include "hatchway/geometry/surface/smooth_sides.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "hatchway/core/disjoint_sets.hpp"
#include "hatchway/geometry/topology/directed_edges.hpp"

namespace hw {
namespace {

std::uint32_t next_corner(std::uint32_t corner)
{
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}

}  // namespace

SmoothSides find_smooth_sides(const WeldedMesh& mesh, float crease_rad)
{
    SmoothSides sides;
    sides.twin.assign(mesh.faces.size() * 3, kNoSide);
    sides.is_crease.assign(sides.twin.size(), false);
    for (const auto& face : mesh.faces) {
        const glm::vec3& p = mesh.positions[face[0]];
        const glm::vec3 area = glm::cross(mesh.positions[face[1]] - p, mesh.positions[face[2]] - p);
        const float size = glm::length(area);
        sides.normals.push_back(size > 0.0f ? area / size : glm::vec3(0.0f));
        sides.areas.push_back(0.5f * size);
    }
    const float crease_cosine = std::cos(crease_rad);
    for_each_edge(sorted_directed_edges(mesh.faces), [&](std::span<const DirectedEdge> uses) {
        if (uses.size() != 2 || uses[0].is_forward == uses[1].is_forward) return;
        const std::uint32_t a = uses[0].face * 3 + uses[0].corner;
        const std::uint32_t b = uses[1].face * 3 + uses[1].corner;
        sides.twin[a] = b;
        sides.twin[b] = a;
        const glm::vec3& normal_a = sides.normals[uses[0].face];
        const glm::vec3& normal_b = sides.normals[uses[1].face];
        const bool has_planes = sides.areas[uses[0].face] > 0.0f && sides.areas[uses[1].face] > 0.0f;
        const bool is_crease = has_planes && glm::dot(normal_a, normal_b) < crease_cosine;
        sides.is_crease[a] = sides.is_crease[b] = is_crease;
        if (is_crease) ++sides.crease_edges;
    });
    return sides;
}

CornerGroups join_corners(const SmoothSides& sides, const std::vector<bool>& is_joined)
{
    DisjointSets sets(sides.twin.size());
    for (std::uint32_t side = 0; side < sets.size(); ++side) {
        const std::uint32_t twin = sides.twin[side];
        if (twin == kNoSide || !is_joined[side]) continue;
        sets.join(side, next_corner(twin));
        sets.join(next_corner(side), twin);
    }
    CornerGroups groups;
    groups.group.assign(sets.size(), kNoSide);
    for (std::uint32_t corner = 0; corner < sets.size(); ++corner) {
        const std::uint32_t root = sets.of(corner);
        if (groups.group[root] == kNoSide) groups.group[root] = groups.count++;
        groups.group[corner] = groups.group[root];
    }
    return groups;
}

}  // namespace hw
