#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "hatchway/world/visibility/tree/exact_planes.hpp"

namespace hw {

/// A convex polygon held as planes: one that it lies in, and one for each side. Its corners are where the plane and two
/// neighbouring sides meet; `corners` are these points rounded, in grid units, for filters and for drawing.
/// Cutting one adds planes and never moves a corner: pieces of a polygon cover exactly what it covered.
struct PlanePolygon {
    int plane = 0;
    std::vector<SidePlane> sides;     ///< In order around; side i runs from corner i to corner i + 1.
    std::vector<glm::dvec3> corners;  ///< As many as there are sides, at least three.

    int corner_count() const { return static_cast<int>(sides.size()); }
};

/// The exact sign of a corner at a plane of the set.
int corner_sign(const PlaneSet& planes, const PlanePolygon& polygon, int corner, int plane);

/// Where a polygon lies to a plane: which signs its corners have.
struct PolygonSigns {
    bool has_front = false;
    bool has_back = false;
};
PolygonSigns polygon_signs(const PlaneSet& planes, const PlanePolygon& polygon, int plane);

/// The part of the polygon on the inside of `cut`. The polygon has corners strictly on both sides of it.
PlanePolygon clipped(const PlaneSet& planes, const PlanePolygon& polygon, SidePlane cut);

/// A flat ring of grid points in a plane, seen along the plane's major axis: (u, v) are the two other axes, counter-
/// clockwise about the major axis. Corners that lie on a straight side are left out.
using FlatRing = std::vector<std::array<std::int64_t, 2>>;

/// The axis of the largest component of the plane's normal, the first of equals: the plane is a graph over the others.
int major_axis(const ExactPlane& plane);

/// The polygon over a strictly convex, counter-clockwise ring in an existing plane. Adds the planes of its sides.
PlanePolygon polygon_over_ring(PlaneSet& planes, int plane, const FlatRing& ring);

/// The plane's cut through a box of grid points, all of it.
PlanePolygon plane_within_box(PlaneSet& planes, int plane, const std::array<std::int64_t, 3>& min,
                              const std::array<std::int64_t, 3>& max);

/// Area in square grid units, from the rounded corners.
double area(const PlanePolygon& polygon);

}  // namespace hw
