#include "hatchway/geometry/surface/complex_edges.hpp"

#include <glm/geometric.hpp>
#include <optional>

#include "hatchway/geometry/surface/surface_faces.hpp"

namespace hw {
namespace {

constexpr float kFlatRad = 0.0175f;
constexpr std::size_t kMostFaces = 16;

/// A face at the edge.
struct Wing {
    std::uint32_t face;
    glm::dvec3 normal;
    glm::dvec3 way;  ///< From the edge into the face, object space.
};

Wing wing_of(const Surface& surface, std::uint32_t face, const glm::dvec3& from, const glm::dvec3& along)
{
    glm::dvec3 middle(0.0);
    for (const std::uint32_t corner : surface.faces[face]) middle += glm::dvec3(surface.positions[corner]) / 3.0;
    const glm::dvec3 way = middle - from;
    return {face, plane_normal(surface, face), way - along * (glm::dot(way, along) / glm::dot(along, along))};
}

bool are_in_one_plane(const Wing& a, const Wing& b)
{
    return angle_between(a.normal, b.normal) <= kFlatRad;
}

/// A face that another one goes on from, across the edge.
std::optional<Wing> straight_on(const std::vector<Wing>& wings)
{
    for (std::size_t i = 0; i < wings.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (are_in_one_plane(wings[i], wings[k]) && glm::dot(wings[i].way, wings[k].way) < 0.0) return wings[i];
    return std::nullopt;
}

}  // namespace

std::vector<std::uint32_t> faces_that_show(const Surface& surface, std::uint32_t edge)
{
    const auto [a, b] = surface.edges[edge].faces();
    std::vector<std::uint32_t> all{a, b};
    for (const MoreFace& more : surface.edges.more_faces_at(edge)) all.push_back(more.face);
    if (all.size() > kMostFaces) return all;
    const auto [first, last] = edge_vertices(surface, edge);
    const glm::dvec3 from(surface.positions[first]), along = glm::dvec3(surface.positions[last]) - from;
    std::vector<Wing> wings;
    for (const std::uint32_t face : all) wings.push_back(wing_of(surface, face, from, along));
    const std::optional<Wing> flat = straight_on(wings);
    if (!flat) return all;
    std::erase_if(wings, [&](const Wing& wing) { return are_in_one_plane(wing, *flat); });
    if (wings.empty() || straight_on(wings)) return all;
    std::vector<std::uint32_t> rest;
    for (const Wing& wing : wings) rest.push_back(wing.face);
    return rest;
}

}  // namespace hw
