#pragma once

#include <cstddef>
#include <vector>

#include "hatchway/world/visibility/tree/coplanar.hpp"

namespace hw {

/// Leaves of many triangles those in the planes with most area, about `most` of them, in their order; named ones stay.
/// Which triangles share a plane is estimated in one pass, by cells of direction and offset: merge_coplanar() is exact,
/// but slow for millions of facets that are too small to block anything. Nothing is left out where there are no more
/// than `most`. Returns how many were. Deterministic.
std::size_t keep_in_large_planes(std::vector<GridTriangle>& triangles, std::size_t most, double step_m);

}  // namespace hw
