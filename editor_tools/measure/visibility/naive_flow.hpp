#pragma once

#include <vector>

#include "hatchway/world/visibility/rows/pvs.hpp"
#include "hatchway/world/visibility/tree/portal_polygon.hpp"

namespace hw::measure {

/// A baseline to compare build_pvs() with: single-threaded recursive flow through the portals with separating planes in
/// both directions, each plane tried against every point, portals that may see little first, results of finished
/// portals reused, sets of leaves as bits in words, and
/// no memory taken at a cut. Rows of the leaves named in `from_leaves`; the others stay empty.
/// Only portals out of these leaves are flowed, so the fewer leaves are named the less there is to reuse. Shares no
/// source with build_pvs() but its data types (a polygon of over 32 corners becomes the rectangle around it in both).
/// Source: the compilers that followed Quake (1996), as an idea.
LeafRows naive_flow(const PortalGraph& graph, const std::vector<int>& from_leaves, const ClipTolerance& tolerance);

}  // namespace hw::measure
