#pragma once

#include "world/bsp.hpp"
#include "world/pvs.hpp"

namespace hw {

/// Openings narrower than this are closed: cracks that modelling and the grid leave between polygons that should meet.
inline constexpr double kCrackWidth = 5e-5;  // metres

/// The openings between the clusters of a tree: where two touch, less what is covered by a polygon that is drawn from the
/// side that one comes from, and less what is inside of walls. Positions in metres relative to the grid's origin. Covered
/// parts are cut away exactly; what remains of one contact is one portal where that adds little, else several.
///
/// Sets BspTree::is_solid. A leaf is solid if its room (the leaves that are open to each other both ways) is bounded by
/// the backs of single-sided surfaces more than by faces, and nothing open leads into it from a leaf that is not: no sight
/// line from elsewhere gets in. Whoever is in one sees through all walls.
PortalGraph build_portals(BspBuild& build);

}  // namespace hw
