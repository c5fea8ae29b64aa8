#pragma once

#include "world/bsp.hpp"
#include "world/pvs.hpp"

namespace hw {

/// Openings narrower than this are closed: cracks that modelling and the grid leave between polygons that should meet.
inline constexpr double kCrackWidth = 5e-5;  // metres

/// The openings of a tree: where two leaves touch, less what is covered by a polygon that is drawn from the side that one
/// comes from. Positions in metres relative to the grid's origin. Covered parts are cut away exactly; what remains of one
/// contact is one portal where that adds little, else several.
/// A leaf is solid if it is only behind surfaces: its room (the leaves that are open to each other both ways) shows the
/// backs of single-sided surfaces and no faces. Whoever is there sees through all walls.
PortalGraph build_portals(BspBuild& build);

}  // namespace hw
