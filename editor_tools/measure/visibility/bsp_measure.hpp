#pragma once

#include <cstdint>

#include "hatchway/world/visibility/tree/bsp.hpp"

namespace hw::measure {

/// Points for which the walk down the tree and exact arithmetic on the stored planes name different leaves. Random
/// points of the tree's box, the same for the same seed; every other one lies within a few grid steps of a plane of the
/// tree: those that a careless test gets wrong.
std::uint64_t misclassified(const BspTree& tree, std::uint64_t points, std::uint32_t seed = 1);

/// How far the area of the tree's pieces is from `area_m2`, that of the polygons it was made from, as a share of it; no
/// value where that is 0.
double relative_area_error(double area_m2, const BspBuild& build);

}  // namespace hw::measure
