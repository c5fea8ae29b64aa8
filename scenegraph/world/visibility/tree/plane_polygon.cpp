// Bernstein, Fussell. Fast, exact, linear booleans. SGP 2009: polygons as planes, so that one predicate decides all.
#include "hatchway/world/visibility/tree/plane_polygon.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

int previous(int corner, int count)
{
    return corner == 0 ? count - 1 : corner - 1;
}

std::size_t at(int index)
{
    return static_cast<std::size_t>(index);
}

/// The vertical plane over the line from a to b in the (u, v) plane; its inside is to the left.
SidePlane side_plane(PlaneSet& planes, int axis, const std::array<std::int64_t, 2>& a,
                     const std::array<std::int64_t, 2>& b)
{
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    std::array<std::int64_t, 3> normal{};
    normal[at(u)] = a[1] - b[1];
    normal[at(v)] = b[0] - a[0];
    const Int128 offset = -(static_cast<Int128>(normal[at(u)]) * a[0] + static_cast<Int128>(normal[at(v)]) * a[1]);
    return planes.add(make_plane(normal, offset));
}

}  // namespace

int corner_sign(const PlaneSet& planes, const PlanePolygon& polygon, int corner, int plane)
{
    const int before = polygon.sides[at(previous(corner, polygon.corner_count()))].plane;
    return planes.sign(plane, polygon.plane, before, polygon.sides[at(corner)].plane, polygon.corners[at(corner)]);
}

PolygonSigns polygon_signs(const PlaneSet& planes, const PlanePolygon& polygon, int plane)
{
    PolygonSigns result;
    if (polygon.plane == plane) return result;
    for (int i = 0; i < polygon.corner_count(); ++i) {
        const int sign = corner_sign(planes, polygon, i, plane);
        result.has_front |= sign > 0;
        result.has_back |= sign < 0;
    }
    return result;
}

PlanePolygon clipped(const PlaneSet& planes, const PlanePolygon& polygon, SidePlane cut)
{
    const int count = polygon.corner_count();
    std::vector<int> inside(at(count));
    for (int i = 0; i < count; ++i) {
        const int sign = corner_sign(planes, polygon, i, cut.plane);
        inside[at(i)] = cut.is_flipped ? -sign : sign;
    }
    PlanePolygon result;
    result.plane = polygon.plane;
    for (int i = 0; i < count; ++i) {
        const int next = i + 1 == count ? 0 : i + 1;
        // A side stays if a part of it lies strictly inside; the cut follows the side that leaves.
        if (inside[at(i)] <= 0 && inside[at(next)] <= 0) continue;
        const SidePlane side = polygon.sides[at(i)];
        const bool enters = inside[at(i)] < 0;
        result.sides.push_back(side);
        result.corners.push_back(enters ? planes.meeting_point(polygon.plane, cut.plane, side.plane)
                                        : polygon.corners[at(i)]);
        if (inside[at(next)] > 0 || (inside[at(next)] == 0 && inside[at((next + 1) % count)] > 0)) continue;
        result.sides.push_back(cut);
        result.corners.push_back(inside[at(next)] == 0 ? polygon.corners[at(next)]
                                                       : planes.meeting_point(polygon.plane, side.plane, cut.plane));
    }
    HW_ASSERT(result.sides.size() >= 3);
    return result;
}

int major_axis(const ExactPlane& plane)
{
    const auto magnitude = [&](std::size_t i) { return plane.normal[i] < 0 ? -plane.normal[i] : plane.normal[i]; };
    int axis = 0;
    for (int i = 1; i < 3; ++i) {
        if (magnitude(at(i)) > magnitude(at(axis))) axis = i;
    }
    return axis;
}

PlanePolygon polygon_over_ring(PlaneSet& planes, int plane, const FlatRing& ring)
{
    const int axis = major_axis(planes[plane]);
    PlanePolygon polygon;
    polygon.plane = plane;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        polygon.sides.push_back(side_plane(planes, axis, ring[i], ring[(i + 1) % ring.size()]));
    }
    for (int i = 0; i < polygon.corner_count(); ++i) {
        const int before = polygon.sides[at(previous(i, polygon.corner_count()))].plane;
        polygon.corners.push_back(planes.meeting_point(plane, before, polygon.sides[at(i)].plane));
    }
    return polygon;
}

PlanePolygon plane_within_box(PlaneSet& planes, int plane, const std::array<std::int64_t, 3>& min,
                              const std::array<std::int64_t, 3>& max)
{
    const int axis = major_axis(planes[plane]);
    const std::size_t u = at((axis + 1) % 3);
    const std::size_t v = at((axis + 2) % 3);
    PlanePolygon polygon =
        polygon_over_ring(planes, plane, {{min[u], min[v]}, {max[u], min[v]}, {max[u], max[v]}, {min[u], max[v]}});
    for (const bool is_upper : {false, true}) {
        std::array<std::int64_t, 3> normal{};
        normal[at(axis)] = is_upper ? -1 : 1;
        const SidePlane cut = planes.add(make_plane(normal, is_upper ? max[at(axis)] : -min[at(axis)]));
        const PolygonSigns signs = polygon_signs(planes, polygon, cut.plane);
        if (signs.has_front && signs.has_back) polygon = clipped(planes, polygon, cut);
    }
    return polygon;
}

double area(const PlanePolygon& polygon)
{
    glm::dvec3 sum(0.0);
    for (std::size_t i = 2; i < polygon.corners.size(); ++i) {
        sum += glm::cross(polygon.corners[i - 1] - polygon.corners[0], polygon.corners[i] - polygon.corners[0]);
    }
    return 0.5 * glm::length(sum);
}

}  // namespace hw
