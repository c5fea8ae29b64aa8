#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/box.hpp"
#include "world/exact_planes.hpp"
#include "world/plane_polygon.hpp"

namespace hw {

/// A polygon that partitions space and blocks sight from the sides from which it is drawn. Front is where its plane of
/// the PlaneSet is positive.
struct BlockingPolygon {
    PlanePolygon polygon;
    bool blocks_from_front = false;
    bool blocks_from_back = false;
    bool is_splitter = true;  ///< False: blocks where a plane of the tree happens to hold it, never splits space itself.
};

/// An inner node. Children: a node's index, or a leaf as ~leaf.
struct BspNode {
    ExactPlane plane;
    int front = ~0;  ///< Where the plane is positive.
    int back = ~0;   ///< Where it is negative or zero.
};

/// The tree alone, for asking where a point is.
struct BspTree {
    Grid grid;
    Box bounds_world;  ///< What the leaves fill; a point outside belongs to no leaf.
    std::vector<BspNode> nodes;  ///< Root first; without nodes there is one leaf, 0.
    int leaf_count = 1;
};

/// A tree with what it was made from, for portals and measures.
struct BspBuild {
    BspTree tree;
    PlaneSet planes;
    std::vector<int> plane_of_node;
    std::vector<std::vector<BlockingPolygon>> polygons_of_node;  ///< The pieces that lie in each node's plane.
    std::array<std::int64_t, 3> box_min{};                       ///< Grid points.
    std::array<std::int64_t, 3> box_max{};
    int depth = 0;
    int piece_count = 0;
    double lost_area = 0.0;  ///< Square grid units of polygons that are no splitters and that no plane of the tree held.
};

/// Splits space by the planes of `polygons`, which lie within the box; every decision is exact, so no piece is lost,
/// doubled or misplaced. The splitter is the plane of least measured cost (pieces cut, balance, area that it takes along)
/// among a fixed number of candidates: the largest polygons of the node and an even sample of the rest.
BspBuild build_bsp(const Grid& grid, PlaneSet planes, std::vector<BlockingPolygon> polygons,
                   const std::array<std::int64_t, 3>& box_min, const std::array<std::int64_t, 3>& box_max);

/// The leaf of a point, by exact signs; -1 outside of the box.
int leaf_at(const BspTree& tree, const glm::dvec3& point_world);

/// Every leaf that the ball touches, ascending; a leaf a few grid steps away may be among them. Empty if the ball is not
/// wholly within the box.
std::vector<int> leaves_near(const BspTree& tree, const glm::dvec3& centre_world, double radius_m);

/// Every leaf that the convex polygon touches within `slack_m`, ascending. At most 16 corners.
void leaves_of_polygon(const BspTree& tree, std::span<const glm::dvec3> corners_world, double slack_m,
                       std::vector<int>& leaves);

}  // namespace hw
