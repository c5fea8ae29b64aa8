#include "hatchway/world/visibility/tree/bsp.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>

#include "hatchway/core/error.hpp"
#include "hatchway/world/visibility/tree/convex_cell.hpp"

namespace hw {
namespace {

constexpr int kLargestTried = 16;           // candidate planes by area
constexpr int kSampledTried = 16;           // and evenly among the others
constexpr std::size_t kMostMeasured = 400;  // polygons that a candidate's cost is measured on
constexpr double kCutCost = 6.0;
constexpr double kBalanceCost = 1.0;
constexpr double kAreaGain = 2.0;

struct Candidate {
    int plane = 0;
    double area = 0.0;
};

/// The planes of the structure (of the details) among the polygons with their areas, largest first.
std::vector<Candidate> planes_by_area(const std::vector<BlockingPolygon>& polygons, bool of_details)
{
    std::map<int, double> area_of_plane;
    for (const BlockingPolygon& polygon : polygons) {
        if (polygon.is_detail == of_details) area_of_plane[polygon.polygon.plane] += area(polygon.polygon);
    }
    std::vector<Candidate> result;
    for (const auto& [plane, plane_area] : area_of_plane) result.push_back({plane, plane_area});
    std::stable_sort(result.begin(), result.end(),
                     [](const Candidate& a, const Candidate& b) { return a.area > b.area; });
    return result;
}

std::vector<Candidate> candidates_of(const std::vector<Candidate>& planes)
{
    const std::size_t largest = std::min<std::size_t>(planes.size(), kLargestTried);
    std::vector<Candidate> result(planes.begin(), planes.begin() + static_cast<std::ptrdiff_t>(largest));
    const std::size_t rest = planes.size() - largest;
    const std::size_t sampled = std::min<std::size_t>(rest, kSampledTried);
    for (std::size_t i = 0; i < sampled; ++i) result.push_back(planes[largest + i * rest / sampled]);
    return result;
}

/// What splitting by the plane would cost, on rounded distances: a heuristic need not be exact.
double cost_of(const ExactPlane& plane, double area_share, const std::vector<BlockingPolygon>& polygons)
{
    constexpr double kOnPlane = 0.25;  // grid steps
    const std::size_t measured = std::min(polygons.size(), kMostMeasured);
    int cut = 0, front = 0, back = 0;
    for (std::size_t i = 0; i < measured; ++i) {
        bool has_front = false, has_back = false;
        for (const glm::dvec3& corner : polygons[i * polygons.size() / measured].polygon.corners) {
            const double distance = plane.distance(corner);
            has_front |= distance > kOnPlane;
            has_back |= distance < -kOnPlane;
        }
        cut += has_front && has_back;
        front += has_front;
        back += has_back;
    }
    const double count = static_cast<double>(measured);
    return kCutCost * cut / count + kBalanceCost * std::abs(front - back) / count - kAreaGain * area_share;
}

int best_splitter(const PlaneSet& planes, const std::vector<BlockingPolygon>& polygons, bool of_details)
{
    const std::vector<Candidate> by_area = planes_by_area(polygons, of_details);
    if (by_area.size() == 1) return by_area.front().plane;
    double total = 0.0;
    for (const Candidate& candidate : by_area) total += candidate.area;
    int best = by_area.front().plane;
    double best_cost = std::numeric_limits<double>::infinity();
    for (const Candidate& candidate : candidates_of(by_area)) {
        const double cost = cost_of(planes[candidate.plane], candidate.area / total, polygons);
        if (cost >= best_cost) continue;
        best_cost = cost;
        best = candidate.plane;
    }
    return best;
}

struct Parts {
    std::vector<BlockingPolygon> on, front, back;
};

Parts split(const PlaneSet& planes, std::vector<BlockingPolygon> polygons, int plane)
{
    Parts parts;
    for (BlockingPolygon& polygon : polygons) {
        const PolygonSigns signs = polygon_signs(planes, polygon.polygon, plane);
        if (!signs.has_front && !signs.has_back) {
            parts.on.push_back(std::move(polygon));
        } else if (!signs.has_back) {
            parts.front.push_back(std::move(polygon));
        } else if (!signs.has_front) {
            parts.back.push_back(std::move(polygon));
        } else {
            BlockingPolygon front = polygon;
            front.polygon = clipped(planes, polygon.polygon, {plane, false});
            parts.front.push_back(std::move(front));
            polygon.polygon = clipped(planes, polygon.polygon, {plane, true});
            parts.back.push_back(std::move(polygon));
        }
    }
    return parts;
}

/// Builds a tree from the root down: structure splits first, then planes across what is long, then details.
class TreeBuilder {
 public:
    /// Parts of two grid steps can be halved no further.
    TreeBuilder(BspBuild& build, double most_part, const BspLimits& limits)
        : build_(build), limits_(limits), most_part_(std::max(most_part, 2.0))
    {
    }

    /// Whether the limits have run out: then what was built is no tree.
    bool has_given_up() const { return build_.tree.leaf_count > limits_.most_leaves || steps_ > limits_.most_steps; }

    int build_structure(std::vector<BlockingPolygon> polygons, const ConvexCell& cell, int depth)
    {
        if (has_given_up()) return ~0;
        const bool has_structure = std::any_of(polygons.begin(), polygons.end(),
                                               [](const BlockingPolygon& polygon) { return !polygon.is_detail; });
        if (!has_structure) {
            const int cluster = build_.tree.cluster_count++;
            return build_part(std::move(polygons), cell, cluster, depth);
        }
        const int plane = best_splitter(build_.planes, polygons, false);
        const FlowPlane rounded{build_.planes[plane].unit_normal, build_.planes[plane].unit_offset};
        Parts parts = split(std::move(polygons), plane);
        const std::size_t index = add_node(plane, std::move(parts.on), depth);
        const int front = build_structure(std::move(parts.front), cell.in_front_of(rounded), depth + 1);
        build_.tree.nodes[index].front = front;
        const int back =
            build_structure(std::move(parts.back), cell.in_front_of({-rounded.normal, -rounded.offset}), depth + 1);
        build_.tree.nodes[index].back = back;
        return static_cast<int>(index);
    }

 private:
    /// Halves the cell across its longest side while that is too long.
    int build_part(std::vector<BlockingPolygon> polygons, const ConvexCell& cell, int cluster, int depth)
    {
        if (has_given_up()) return ~0;
        const Box bounds = cell.bounds();
        const glm::dvec3 size = cell.is_empty() ? glm::dvec3(0.0) : bounds.size();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        if (!(size[axis] > most_part_)) return build_details(std::move(polygons), cluster, part_count_++, depth);
        const std::int64_t place = static_cast<std::int64_t>(std::round(bounds.centre()[axis]));
        std::array<std::int64_t, 3> normal{};
        normal[static_cast<std::size_t>(axis)] = 1;
        const int plane = build_.planes.add(make_plane(normal, -static_cast<Int128>(place))).plane;
        const FlowPlane rounded{build_.planes[plane].unit_normal, build_.planes[plane].unit_offset};
        Parts parts = split(std::move(polygons), plane);
        const std::size_t index = add_node(plane, std::move(parts.on), depth);
        const int front = build_part(std::move(parts.front), cell.in_front_of(rounded), cluster, depth + 1);
        build_.tree.nodes[index].front = front;
        const int back =
            build_part(std::move(parts.back), cell.in_front_of({-rounded.normal, -rounded.offset}), cluster, depth + 1);
        build_.tree.nodes[index].back = back;
        return static_cast<int>(index);
    }

    int build_details(std::vector<BlockingPolygon> polygons, int cluster, int part, int depth)
    {
        if (has_given_up()) return ~0;
        if (polygons.empty()) {
            build_.depth = std::max(build_.depth, depth);
            build_.tree.cluster_of_leaf.push_back(cluster);
            build_.part_of_leaf.push_back(part);
            return ~(build_.tree.leaf_count++);
        }
        const int plane = best_splitter(build_.planes, polygons, true);
        Parts parts = split(std::move(polygons), plane);
        const std::size_t index = add_node(plane, std::move(parts.on), depth);
        const int front = build_details(std::move(parts.front), cluster, part, depth + 1);
        build_.tree.nodes[index].front = front;
        const int back = build_details(std::move(parts.back), cluster, part, depth + 1);
        build_.tree.nodes[index].back = back;
        return static_cast<int>(index);
    }

    Parts split(std::vector<BlockingPolygon> polygons, int plane)
    {
        steps_ += polygons.size();
        return hw::split(build_.planes, std::move(polygons), plane);
    }

    std::size_t add_node(int plane, std::vector<BlockingPolygon> on, int depth)
    {
        build_.depth = std::max(build_.depth, depth);
        build_.piece_count += static_cast<int>(on.size());
        build_.tree.nodes.push_back({build_.planes[plane]});
        build_.plane_of_node.push_back(plane);
        build_.polygons_of_node.push_back(std::move(on));
        return build_.tree.nodes.size() - 1;
    }

    BspBuild& build_;
    BspLimits limits_;
    std::size_t steps_ = 0;
    double most_part_;  ///< Grid steps.
    int part_count_ = 0;
};

Box box_of(const std::array<std::int64_t, 3>& min, const std::array<std::int64_t, 3>& max)
{
    return {glm::dvec3(static_cast<double>(min[0]), static_cast<double>(min[1]), static_cast<double>(min[2])),
            glm::dvec3(static_cast<double>(max[0]), static_cast<double>(max[1]), static_cast<double>(max[2]))};
}

BspBuild empty_build(const Grid& grid, const PlaneSet& planes, const std::array<std::int64_t, 3>& box_min,
                     const std::array<std::int64_t, 3>& box_max)
{
    BspBuild build;
    build.tree.grid = grid;
    build.planes = planes;
    build.box_min = box_min;
    build.box_max = box_max;
    const Box box_grid = box_of(box_min, box_max);
    build.tree.bounds_world = {grid.origin_world + box_grid.min * grid.step_m,
                               grid.origin_world + box_grid.max * grid.step_m};
    build.tree.leaf_count = 0;
    build.tree.cluster_count = 0;
    return build;
}

/// Planes that all cross each other are told by the leaves that each polygon makes.
BspLimits limits_of(std::size_t polygon_count, BspLimits limits)
{
    const auto most = static_cast<double>(limits.least_leaves) +
                      static_cast<double>(limits.leaves_of_polygon) * static_cast<double>(polygon_count);
    limits.most_leaves = static_cast<int>(std::min(most, static_cast<double>(limits.most_leaves)));
    return limits;
}

bool is_inside(const Box& box, const glm::dvec3& p)
{
    return p.x >= box.min.x && p.x <= box.max.x && p.y >= box.min.y && p.y <= box.max.y && p.z >= box.min.z &&
           p.z <= box.max.z;
}

glm::dvec3 to_grid(const Grid& grid, const glm::dvec3& p)
{
    return (p - grid.origin_world) / grid.step_m;
}

void collect_near(const BspTree& tree, int child, const glm::dvec3& centre_grid, double reach, std::vector<int>& leaves)
{
    if (child < 0) {
        leaves.push_back(~child);
        return;
    }
    const BspNode& node = tree.nodes[static_cast<std::size_t>(child)];
    const double distance = node.plane.distance(centre_grid);
    if (distance >= -reach) collect_near(tree, node.front, centre_grid, reach, leaves);
    if (distance <= reach) collect_near(tree, node.back, centre_grid, reach, leaves);
}

void collect_box(const BspTree& tree, int child, const glm::dvec3& centre, const glm::dvec3& half, double reach,
                 std::vector<int>& leaves)
{
    if (child < 0) {
        leaves.push_back(~child);
        return;
    }
    const BspNode& node = tree.nodes[static_cast<std::size_t>(child)];
    const double distance = node.plane.distance(centre);
    const double radius = glm::dot(glm::abs(node.plane.unit_normal), half) + reach;
    if (distance >= -radius) collect_box(tree, node.front, centre, half, reach, leaves);
    if (distance <= radius) collect_box(tree, node.back, centre, half, reach, leaves);
}

int root_of(const BspTree& tree)
{
    return tree.nodes.empty() ? ~0 : 0;
}

constexpr std::size_t kMostCorners = 48;

struct Corners {
    std::array<glm::dvec3, kMostCorners> points;
    std::size_t count = 0;
};

/// The part of the polygon where plane * sign >= -reach.
Corners cut(const Corners& polygon, const ExactPlane& plane, double sign, double reach)
{
    Corners result;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const glm::dvec3& a = polygon.points[i];
        const glm::dvec3& b = polygon.points[(i + 1) % polygon.count];
        const double at_a = sign * plane.distance(a) + reach;
        const double at_b = sign * plane.distance(b) + reach;
        if (at_a >= 0.0) result.points[result.count++] = a;
        if ((at_a < 0.0) != (at_b < 0.0)) result.points[result.count++] = a + (b - a) * (at_a / (at_a - at_b));
    }
    return result;
}

/// `facing` is the normal of a polygon that is drawn from its front only, zero for one drawn from both sides.
void collect_leaves(const BspTree& tree, int child, const Corners& polygon, const glm::dvec3& facing, double reach,
                    std::vector<int>& leaves)
{
    if (child < 0) {
        leaves.push_back(~child);
        return;
    }
    const BspNode& node = tree.nodes[static_cast<std::size_t>(child)];
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const double distance = node.plane.distance(polygon.points[i]);
        least = std::min(least, distance);
        most = std::max(most, distance);
    }
    const bool is_cut = least < -reach && most > reach && polygon.count + 2 <= kMostCorners;
    bool is_in_front = most >= -reach;
    bool is_behind = least <= reach;
    if (is_in_front && is_behind && !is_cut && most - least <= 2.0 * reach) {
        // It lies in the plane: who sees it comes from the side that it looks to.
        const double looks = glm::dot(facing, node.plane.unit_normal);
        if (looks > 0.9) is_behind = false;
        if (looks < -0.9) is_in_front = false;
    }
    const auto part = [&](double sign) { return is_cut ? cut(polygon, node.plane, sign, reach) : polygon; };
    if (is_in_front) collect_leaves(tree, node.front, part(1.0), facing, reach, leaves);
    if (is_behind) collect_leaves(tree, node.back, part(-1.0), facing, reach, leaves);
}

}  // namespace

BspBuild build_bsp(const Grid& grid, PlaneSet planes, std::vector<BlockingPolygon> polygons,
                   const std::array<std::int64_t, 3>& box_min, const std::array<std::int64_t, 3>& box_max,
                   double most_part_m, const BspLimits& limits)
{
    const std::size_t polygon_count = polygons.size();
    while (true) {
        BspBuild build = empty_build(grid, planes, box_min, box_max);
        TreeBuilder builder(build, most_part_m / grid.step_m, limits_of(polygons.size(), limits));
        const bool is_last = polygons.empty();
        builder.build_structure(polygons, ConvexCell(box_of(box_min, box_max)), 0);
        build.left_out = polygon_count - polygons.size();
        build.tree.is_solid.assign(static_cast<std::size_t>(build.tree.leaf_count), 0);
        if (is_last || !builder.has_given_up()) return build;
        polygons.resize(polygons.size() / 3);
    }
}

int leaf_at(const BspTree& tree, const glm::dvec3& point_world)
{
    if (!is_inside(tree.bounds_world, point_world)) return -1;
    int child = root_of(tree);
    while (child >= 0) {
        const BspNode& node = tree.nodes[static_cast<std::size_t>(child)];
        child = exact_sign(tree.grid, node.plane, point_world) > 0 ? node.front : node.back;
    }
    return ~child;
}

std::vector<int> leaves_near(const BspTree& tree, const glm::dvec3& centre_world, double radius_m)
{
    std::vector<int> leaves;
    if (!is_inside(tree.bounds_world, centre_world - radius_m)) return leaves;
    if (!is_inside(tree.bounds_world, centre_world + radius_m)) return leaves;
    const glm::dvec3 centre = to_grid(tree.grid, centre_world);
    // A grid step and a half more: the structure was snapped, the scene that is drawn was not.
    const double reach = radius_m / tree.grid.step_m + 2.0;
    collect_near(tree, root_of(tree), centre, reach, leaves);
    std::sort(leaves.begin(), leaves.end());
    return leaves;
}

void leaves_of_polygon(const BspTree& tree, std::span<const glm::dvec3> corners_world, const glm::dvec3& facing,
                       double slack_m, std::vector<int>& leaves)
{
    HW_ASSERT(corners_world.size() <= 16);
    Corners polygon;
    for (const glm::dvec3& corner : corners_world) polygon.points[polygon.count++] = to_grid(tree.grid, corner);
    const std::size_t first = leaves.size();
    collect_leaves(tree, root_of(tree), polygon, facing, slack_m / tree.grid.step_m, leaves);
    const auto begin = leaves.begin() + static_cast<std::ptrdiff_t>(first);
    std::sort(begin, leaves.end());
    leaves.erase(std::unique(begin, leaves.end()), leaves.end());
}

void leaves_of_box(const BspTree& tree, const Box& box_world, double slack_m, std::vector<int>& leaves)
{
    const std::size_t first = leaves.size();
    collect_box(tree, root_of(tree), to_grid(tree.grid, box_world.centre()), 0.5 * box_world.size() / tree.grid.step_m,
                slack_m / tree.grid.step_m, leaves);
    std::sort(leaves.begin() + static_cast<std::ptrdiff_t>(first), leaves.end());
}

}  // namespace hw
