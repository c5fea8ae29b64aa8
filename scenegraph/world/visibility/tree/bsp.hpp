#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

#include "hatchway/core/box.hpp"
#include "hatchway/world/visibility/tree/exact_planes.hpp"
#include "hatchway/world/visibility/tree/plane_polygon.hpp"

namespace hw {

/// A polygon that partitions space and blocks sight from the sides from which it is drawn. Front is where its plane of
/// the PlaneSet is positive.
struct BlockingPolygon {
    PlanePolygon polygon;
    bool blocks_from_front = false;
    bool blocks_from_back = false;
    bool is_detail = false;  ///< Splits space only once all structure has, so that it never cuts the clusters.
};

/// An inner node. Children: a node's index, or a leaf as ~leaf.
struct BspNode {
    ExactPlane plane;
    int front = ~0;  ///< Where the plane is positive.
    int back = ~0;   ///< Where it is negative or zero.
};

/// The tree alone, for asking where a point is. Structure splits space into clusters, details split clusters into
/// leaves. Clusters are convex until merge_clusters(), and are what sees and is seen.
struct BspTree {
    Grid grid;
    Box bounds_world;            ///< What the leaves fill; a point outside belongs to no leaf.
    std::vector<BspNode> nodes;  ///< Root first; without nodes there is one leaf, 0.
    int leaf_count = 1;
    int cluster_count = 1;
    std::vector<int> cluster_of_leaf;
    std::vector<std::uint8_t> is_solid;  ///< By leaf: inside of walls. All 0 until leaf_contacts() has found out.
};

/// A tree with what it was made from, for portals and measures.
struct BspBuild {
    BspTree tree;
    PlaneSet planes;
    std::vector<int> plane_of_node;
    std::vector<int> part_of_leaf;                               ///< Which part of its cluster; counted over all.
    std::vector<std::vector<BlockingPolygon>> polygons_of_node;  ///< The pieces that lie in each node's plane.
    std::array<std::int64_t, 3> box_min{};                       ///< Grid points.
    std::array<std::int64_t, 3> box_max{};
    int depth = 0;
    int piece_count = 0;
    std::size_t left_out = 0;         ///< Of the polygons, the last: for want of room they neither split nor block.
    bool are_covers_complete = true;  ///< False: leaf_contacts() ran out of steps and takes what is left to be open.
};

/// How far a tree may grow: planes that all cross each other part space into cells by the third power of their number.
struct BspLimits {
    int most_leaves = 150'000;
    int leaves_of_polygon = 16;           ///< So many for each polygon; a scene of rooms has two or three.
    int least_leaves = 8192;              ///< That many there may always be.
    std::size_t most_steps = 30'000'000;  ///< Polygons at nodes.
};

/// Splits space by the planes of `polygons`, which lie within the box; every decision is exact, so no piece is lost,
/// doubled or misplaced. The splitter is the plane of least measured cost (pieces cut, balance, area that it takes
/// along) among a fixed number of candidates: the largest polygons of the node and an even sample of the rest.
/// Clusters longer than `most_part_m` are halved into parts by planes across the axes, before details split them. Where
/// the limits run out the first third of the polygons is tried alone, then a ninth and so on.
BspBuild build_bsp(const Grid& grid, PlaneSet planes, std::vector<BlockingPolygon> polygons,
                   const std::array<std::int64_t, 3>& box_min, const std::array<std::int64_t, 3>& box_max,
                   double most_part_m = std::numeric_limits<double>::infinity(), const BspLimits& limits = {});

/// The leaf of a point, by exact signs; -1 outside of the box.
int leaf_at(const BspTree& tree, const glm::dvec3& point_world);

/// Every leaf that the ball touches, ascending; a leaf a few grid steps away may be among them. Empty if the ball is
/// not wholly within the box.
std::vector<int> leaves_near(const BspTree& tree, const glm::dvec3& centre_world, double radius_m);

/// Every leaf that the convex polygon touches within `slack_m`, ascending, appended. At most 16 corners. `facing` is
/// the unit normal of a polygon that is drawn from its front only: where it lies in a plane of the tree it belongs to
/// the side that it looks to alone. Zero for a polygon that is drawn from both sides.
void leaves_of_polygon(const BspTree& tree, std::span<const glm::dvec3> corners_world, const glm::dvec3& facing,
                       double slack_m, std::vector<int>& leaves);

/// Every leaf that a box touches within `slack_m`, ascending, appended; a few more where it is near an edge of a leaf.
void leaves_of_box(const BspTree& tree, const Box& box_world, double slack_m, std::vector<int>& leaves);

}  // namespace hw
