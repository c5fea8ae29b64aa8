#include "hatchway/world/visibility/tree/convex_cell.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace hw {
namespace {

using Face = std::vector<glm::dvec3>;

/// The part of the face in front; where it crosses the plane, the two ends are added to `rim`.
Face clipped(const Face& face, const FlowPlane& plane, Face& rim)
{
    Face result;
    for (std::size_t i = 0; i < face.size(); ++i) {
        const glm::dvec3 &a = face[i], &b = face[(i + 1) % face.size()];
        const double at_a = plane.distance(a), at_b = plane.distance(b);
        if (at_a >= 0.0) result.push_back(a);
        if ((at_a < 0.0) == (at_b < 0.0)) continue;
        result.push_back(a + (b - a) * (at_a / (at_a - at_b)));
        rim.push_back(result.back());
    }
    return result;
}

/// Grows with the angle of a way from the first axis, as std::atan2 does, in [-2, 2]: by a quotient, whose bits are the
/// same on every machine.
double turn_of(double x, double y)
{
    const double size = std::abs(x) + std::abs(y);
    if (size == 0.0) return 0.0;
    const double slope = y / size;
    return x >= 0.0 ? slope : std::copysign(2.0, y) - slope;
}

/// The points of a convex rim in order around its middle.
Face lid(Face rim, const glm::dvec3& normal)
{
    glm::dvec3 middle(0.0);
    for (const glm::dvec3& point : rim) middle += point / static_cast<double>(rim.size());
    const glm::dvec3 helper = std::abs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(helper, normal));
    const glm::dvec3 v = glm::cross(normal, u);
    const auto turn = [&](const glm::dvec3& p) { return turn_of(glm::dot(p - middle, u), glm::dot(p - middle, v)); };
    std::sort(rim.begin(), rim.end(), [&](const glm::dvec3& a, const glm::dvec3& b) { return turn(a) < turn(b); });
    return rim;
}

}  // namespace

ConvexCell::ConvexCell(const Box& box)
{
    const auto corner = [&](int i) {
        return glm::dvec3((i & 1) ? box.max.x : box.min.x, (i & 2) ? box.max.y : box.min.y,
                          (i & 4) ? box.max.z : box.min.z);
    };
    for (int axis = 0; axis < 3; ++axis) {
        const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
        for (const int base : {0, 1 << axis})
            faces_.push_back({corner(base), corner(base | u), corner(base | u | v), corner(base | v)});
    }
}

ConvexCell ConvexCell::in_front_of(const FlowPlane& plane) const
{
    ConvexCell result;
    Face rim;
    for (const Face& face : faces_) {
        Face part = clipped(face, plane, rim);
        if (part.size() >= 3) result.faces_.push_back(std::move(part));
    }
    if (rim.size() >= 3) result.faces_.push_back(lid(std::move(rim), plane.normal));
    return result;
}

Box ConvexCell::bounds() const
{
    Box box;
    for (const Face& face : faces_) {
        for (const glm::dvec3& point : face) box.add(point);
    }
    return box;
}

}  // namespace hw
