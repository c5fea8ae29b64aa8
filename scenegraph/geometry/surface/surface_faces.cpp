#include "hatchway/geometry/surface/surface_faces.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "hatchway/geometry/exact/predicates.hpp"

namespace hw {
namespace {

/// The corner of face B that tells on which side of face A it lies; kNoFace where they have the same corners. All
/// corners of B but its apex lie on the common line, so the apex alone decides. Where a plane is inherited the line may
/// be another one that is close by: then the corner farthest from A decides.
std::uint32_t apex_against(const Surface& surface, const FaceCorners& a, const FaceCorners& b)
{
    std::array<std::uint32_t, 3> others;
    std::size_t count = 0;
    for (const std::uint32_t corner : b)
        if (corner != a[0] && corner != a[1] && corner != a[2]) others[count++] = corner;
    if (count < 2) return count == 0 ? kNoFace : others[0];
    const glm::dvec3 o = surface.positions[a[0]];
    const glm::dvec3 normal =
        glm::cross(glm::dvec3(surface.positions[a[1]]) - o, glm::dvec3(surface.positions[a[2]]) - o);
    const auto distance = [&](std::uint32_t corner) {
        return std::abs(glm::dot(normal, glm::dvec3(surface.positions[corner]) - o));
    };
    return *std::max_element(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(count),
                             [&](std::uint32_t p, std::uint32_t q) { return distance(p) < distance(q); });
}

}  // namespace

std::array<std::uint32_t, 3> face_corners(const Surface& surface, std::uint32_t face)
{
    if (face < surface.faces.size()) return surface.faces[face];
    const auto& turned = surface.faces[surface.filter.twins[face - surface.faces.size()].face];
    return {turned[0], turned[2], turned[1]};
}

std::uint32_t plane_face(const Surface& surface, std::uint32_t face)
{
    if (face == kNoFace) return kNoFace;
    if (face >= surface.faces.size()) face = surface.filter.twins[face - surface.faces.size()].face;
    const auto& inherited = surface.filter.inherited;
    const auto found = std::lower_bound(inherited.begin(), inherited.end(), face,
                                        [](const auto& entry, std::uint32_t id) { return entry.face < id; });
    return found != inherited.end() && found->face == face ? found->source : face;
}

glm::dvec3 plane_normal(const Surface& surface, std::uint32_t face)
{
    const std::uint32_t plane = plane_face(surface, face);
    if (plane == kNoFace) return glm::dvec3(0.0);
    const auto& corners = surface.faces[plane];
    const glm::dvec3 a = surface.positions[corners[0]], b = surface.positions[corners[1]],
                     c = surface.positions[corners[2]];
    const glm::dvec3 normal = surface.normal_from_object * glm::cross(b - a, c - a);
    return face < surface.faces.size() ? normal : -normal;
}

float angle_between(const glm::dvec3& a, const glm::dvec3& b)
{
    if (a == glm::dvec3(0.0) || b == glm::dvec3(0.0)) return 0.0f;
    return static_cast<float>(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

int convexity_sign(const Surface& surface, std::uint32_t face_a, std::uint32_t face_b)
{
    const std::uint32_t plane_a = plane_face(surface, face_a), plane_b = plane_face(surface, face_b);
    if (plane_a == kNoFace || plane_b == kNoFace || plane_a == plane_b) return 0;
    const auto& a = surface.faces[plane_a];
    const std::uint32_t apex = apex_against(surface, a, surface.faces[plane_b]);
    if (apex == kNoFace) return 0;
    const int sign = orient3d_sign(surface.positions[a[0]], surface.positions[a[1]], surface.positions[a[2]],
                                   surface.positions[apex]);
    return face_a < surface.faces.size() ? sign : -sign;
}

}  // namespace hw
