#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "hatchway/world/visibility/tree/exact_planes.hpp"
#include "hatchway/world/visibility/tree/plane_polygon.hpp"

namespace hw {

/// A triangle of grid points, counter-clockwise seen from where it is drawn.
struct GridTriangle {
    std::array<std::array<std::int64_t, 3>, 3> corners{};
    bool is_double_sided = false;
    bool is_named = false;  ///< Of an object that the level names as structure.
};

/// A strictly convex polygon over a plane. Front is where the plane is positive.
struct FlatPolygon {
    ExactPlane plane;
    FlatRing ring;  ///< Counter-clockwise about the plane's major axis.
    bool blocks_from_front = false;
    bool blocks_from_back = false;
    bool is_named = false;
    double area = 0.0;  ///< Square grid units.
};

/// Lays triangles into shared planes (those whose corners are within `tolerance` grid steps of the plane of a larger
/// triangle join it), then merges those of one plane, one pair of sides and one naming across shared edges, while the
/// union is exactly convex and has at most 32 corners. Triangles without area are left out.
std::vector<FlatPolygon> merge_coplanar(std::span<const GridTriangle> triangles, double tolerance);

}  // namespace hw
