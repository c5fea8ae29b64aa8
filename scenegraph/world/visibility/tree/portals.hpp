#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "hatchway/core/box.hpp"
#include "hatchway/world/visibility/tree/bsp.hpp"

namespace hw {

/// Openings narrower than this are closed: cracks that modelling and the grid leave between polygons that should meet.
inline constexpr double kCrackWidth = 5e-5;  // metres; less in scenes of centimetres: see Grid::scaled()

/// Where two leaves touch, and what of it is open for sight from the one and from the other: convex polygons in metres,
/// relative to the grid's origin. What is covered by a polygon that is drawn from the side that one comes from is cut
/// away exactly.
struct LeafContact {
    std::size_t node = 0;  ///< In whose plane they touch.
    int front_leaf = 0;
    int back_leaf = 0;
    double area_m2 = 0.0;
    Box bounds;                                     ///< Of the whole contact, covered or open.
    std::vector<std::vector<glm::dvec3>> backward;  ///< From the front leaf to the back leaf.
    std::vector<std::vector<glm::dvec3>> forward;
};

/// All contacts of a tree's leaves.
///
/// Sets BspTree::is_solid. A leaf is solid if its room (the leaves that are open to each other both ways) is bounded by
/// the backs of single-sided surfaces more than by faces, and nothing open leads into it from a leaf that is not: no
/// sight line from elsewhere gets in. Whoever is in one sees through all walls.
std::vector<LeafContact> leaf_contacts(BspBuild& build);

}  // namespace hw
