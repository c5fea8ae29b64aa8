#include "hatchway/geometry/surface/edge_table.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "hatchway/geometry/surface/surface_faces.hpp"

namespace hw {
namespace {

constexpr float kAngleSlackRad = 1e-6f;  // the rounding of a fold that is meant to equal the crease angle

/// The edges of a group that are folded by more than the crease angle stand first.
std::uint32_t crease_end(const Surface& surface, EdgeRange group, float crease_rad)
{
    std::uint32_t first = group.begin, last = group.end;
    while (first < last) {
        const std::uint32_t middle = first + (last - first) / 2;
        if (fold_rad(surface, middle) > crease_rad + kAngleSlackRad) {
            first = middle + 1;
        } else {
            last = middle;
        }
    }
    return first;
}

}  // namespace

std::span<const MoreFace> EdgeTable::more_faces_at(std::uint32_t edge) const
{
    const auto first = std::ranges::lower_bound(more_faces, edge, {}, &MoreFace::edge);
    const auto end = std::ranges::upper_bound(first, more_faces.end(), edge, {}, &MoreFace::edge);
    return {first, end};
}

float fold_rad(const Surface& surface, std::uint32_t face_a, std::uint32_t face_b)
{
    if (face_a == kNoFace || face_b == kNoFace) return 0.0f;
    return angle_between(plane_normal(surface, face_a), plane_normal(surface, face_b));
}

float fold_rad(const Surface& surface, std::uint32_t edge)
{
    const auto [face_a, face_b] = surface.edges[edge].faces();
    return fold_rad(surface, face_a, face_b);
}

std::array<std::uint32_t, 2> edge_vertices(const Surface& surface, std::uint32_t edge)
{
    const Edge& side = surface.edges[edge];
    const auto& corners = surface.faces[side.face_a()];
    return {corners[side.corner_a()], corners[(side.corner_a() + 1) % 3]};
}

EdgeClasses classes_at(const Surface& surface, float crease_rad)
{
    const EdgeTable& table = surface.edges;
    const auto cut = [&](EdgeGroup group) {
        const EdgeRange range = table.group(group);
        const std::uint32_t end = crease_end(surface, range, crease_rad);
        return std::array<EdgeRange, 2>{EdgeRange{range.begin, end}, EdgeRange{end, range.end}};
    };
    const auto artist_convex = cut(EdgeGroup::artist_convex), artist_reflex = cut(EdgeGroup::artist_reflex);
    const auto convex = cut(EdgeGroup::convex), reflex = cut(EdgeGroup::reflex);
    const auto silent = cut(EdgeGroup::reflex_silent);
    return {.borders = table.group(EdgeGroup::border),
            .ridges = {artist_convex[0], convex[0]},
            .valleys = {artist_reflex[0], reflex[0], silent[0]},
            .artist = {artist_convex[1], artist_reflex[1]},
            .candidates = {convex[1], reflex[1]},
            .silent = silent[1]};
}

}  // namespace hw
