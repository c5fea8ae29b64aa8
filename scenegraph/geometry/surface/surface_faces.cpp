#include "hatchway/geometry/surface/surface_faces.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "hatchway/geometry/exact/predicates.hpp"

namespace hw {

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

int convexity_sign(const Surface& surface, std::uint32_t face_a, std::uint32_t face_b)
{
    const std::uint32_t plane_a = plane_face(surface, face_a), plane_b = plane_face(surface, face_b);
    if (plane_a == kNoFace || plane_b == kNoFace || plane_a == plane_b) return 0;
    const auto& a = surface.faces[plane_a];
    // All corners of B but its apex lie on the common line, so the apex alone decides, whichever corner it is. Where a
    // plane is inherited the line may be another one that is close by: then the corner farthest from it decides.
    const glm::dvec3 o = surface.positions[a[0]];
    const glm::dvec3 normal =
        glm::cross(glm::dvec3(surface.positions[a[1]]) - o, glm::dvec3(surface.positions[a[2]]) - o);
    double farthest = -1.0;
    std::uint32_t apex = kNoFace;
    for (const std::uint32_t corner : surface.faces[plane_b]) {
        if (corner == a[0] || corner == a[1] || corner == a[2]) continue;
        const double distance = std::abs(glm::dot(normal, glm::dvec3(surface.positions[corner]) - o));
        if (distance > farthest) {
            farthest = distance;
            apex = corner;
        }
    }
    if (apex == kNoFace) return 0;
    const int sign = orient3d_sign(surface.positions[a[0]], surface.positions[a[1]], surface.positions[a[2]],
                                   surface.positions[apex]);
    return face_a < surface.faces.size() ? sign : -sign;
}

}  // namespace hw
