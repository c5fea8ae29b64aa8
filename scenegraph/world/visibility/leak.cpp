#include "hatchway/world/visibility/leak.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <queue>

#include "hatchway/world/visibility/tree/bsp.hpp"
#include "hatchway/world/visibility/tree/portals.hpp"
#include "hatchway/world/visibility/tree/structure.hpp"

namespace hw {
namespace {

constexpr double kMargin_m = 1.0;          // of the box around the scene
constexpr double kLeastHoleReach_m = 0.5;  // openings this near to a hole belong to it
constexpr int kNoLeaf = -1;
constexpr int kMostPolygons = 500'000;
constexpr std::size_t kMostTriangles = 8'000'000;
constexpr BspLimits kBspLimits{.most_leaves = 300'000, .least_leaves = 300'000, .most_steps = 30'000'000};

/// Sight from a leaf into its neighbour.
struct Way {
    int to = 0;
    glm::dvec3 middle{0.0};  ///< Of the opening, world space.
    glm::dvec3 out{0.0};     ///< Unit normal of the opening, forward.
    double area_m2 = 0.0;
};

struct Rooms {
    BspBuild build;
    std::vector<std::vector<Way>> ways;    ///< By leaf.
    std::vector<std::uint8_t> is_outside;  ///< By leaf.
    bool are_complete = true;              ///< All that blocks is in them.
};

glm::dvec3 area_vector(const std::vector<glm::dvec3>& winding)
{
    glm::dvec3 sum(0.0);
    for (std::size_t i = 2; i < winding.size(); ++i)
        sum += 0.5 * glm::cross(winding[i - 1] - winding[0], winding[i] - winding[0]);
    return sum;
}

glm::dvec3 middle_of(const std::vector<glm::dvec3>& winding)
{
    glm::dvec3 sum(0.0);
    for (const glm::dvec3& corner : winding) sum += corner;
    return sum / static_cast<double>(winding.size());
}

/// The way through the largest of the openings; its area is that of all.
void add_way(Rooms& rooms, int from, int to, const glm::dvec3& out,
             const std::vector<std::vector<glm::dvec3>>& openings)
{
    if (openings.empty()) return;
    Way way{.to = to, .out = out};
    double largest = -1.0;
    for (const std::vector<glm::dvec3>& opening : openings) {
        const double area = glm::length(area_vector(opening));
        way.area_m2 += area;
        if (area <= largest) continue;
        largest = area;
        way.middle = rooms.build.tree.grid.origin_world + middle_of(opening);
    }
    rooms.ways[static_cast<std::size_t>(from)].push_back(way);
}

Rooms make_rooms(const Scene& scene, const Level& level)
{
    StructureOptions options;
    options.max_structure = kMostPolygons;
    options.max_details = kMostPolygons;
    options.max_triangles = kMostTriangles;
    options.least_area_share = 0.0;
    options.margin_m = kMargin_m;
    Structure structure = choose_structure(scene, level, options);
    const bool is_whole_structure = structure.left_out == 0;
    BspBuild build =
        build_bsp(structure.grid, std::move(structure.planes), std::move(structure.polygons), structure.box_min,
                  structure.box_max, std::numeric_limits<double>::infinity(), kBspLimits);
    const std::vector<LeafContact> contacts = leaf_contacts(build);
    Rooms rooms;
    rooms.are_complete = is_whole_structure && build.left_out == 0 && build.are_covers_complete;
    rooms.build = std::move(build);
    const BspTree& tree = rooms.build.tree;
    rooms.ways.resize(static_cast<std::size_t>(tree.leaf_count));
    rooms.is_outside.resize(rooms.ways.size(), contacts.empty() ? 1 : 0);
    const glm::dvec3 low = tree.bounds_world.min - tree.grid.origin_world;
    const glm::dvec3 high = tree.bounds_world.max - tree.grid.origin_world;
    const double near = 2.0 * tree.grid.step_m;
    for (const LeafContact& contact : contacts) {
        const glm::dvec3& normal = tree.nodes[contact.node].plane.unit_normal;
        add_way(rooms, contact.front_leaf, contact.back_leaf, -normal, contact.backward);
        add_way(rooms, contact.back_leaf, contact.front_leaf, normal, contact.forward);
        for (int axis = 0; axis < 3; ++axis) {
            if (contact.bounds.min[axis] > low[axis] + near && contact.bounds.max[axis] < high[axis] - near) continue;
            rooms.is_outside[static_cast<std::size_t>(contact.front_leaf)] = 1;
            rooms.is_outside[static_cast<std::size_t>(contact.back_leaf)] = 1;
        }
    }
    return rooms;
}

/// A hole that has been told already.
struct Hole {
    glm::dvec3 middle{0.0};
    double reach_m = 0.0;
};

bool is_told(const std::vector<Hole>& holes, const Way& way)
{
    return std::any_of(holes.begin(), holes.end(),
                       [&](const Hole& hole) { return glm::distance(hole.middle, way.middle) <= hole.reach_m; });
}

/// How a leaf was reached.
struct Arrival {
    double cost = std::numeric_limits<double>::infinity();
    int from = kNoLeaf;
    const Way* way = nullptr;
    glm::dvec3 point{0.0};
};

struct Search {
    const Rooms& rooms;
    const std::vector<Hole>& told;
    double least_m2 = 0.0;    ///< Ways narrower than this are not gone.
    bool wants_wide = false;  ///< Cost is minus the narrowest opening so far, else metres.
    std::vector<Arrival> arrivals;

    /// The outside leaf of least cost, or kNoLeaf. Dijkstra.
    int run(int start, const glm::dvec3& from)
    {
        using Entry = std::pair<double, int>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> pending;
        arrivals.assign(rooms.ways.size(), {});
        const double first = wants_wide ? -std::numeric_limits<double>::max() : 0.0;
        arrivals[static_cast<std::size_t>(start)] = {first, kNoLeaf, nullptr, from};
        pending.emplace(first, start);
        while (!pending.empty()) {
            const auto [cost, leaf] = pending.top();
            pending.pop();
            const Arrival here = arrivals[static_cast<std::size_t>(leaf)];
            if (cost > here.cost) continue;
            if (rooms.is_outside[static_cast<std::size_t>(leaf)]) return leaf;
            for (const Way& way : rooms.ways[static_cast<std::size_t>(leaf)]) {
                if (way.area_m2 < least_m2 || is_told(told, way)) continue;
                const double next =
                    wants_wide ? std::max(cost, -way.area_m2) : cost + glm::distance(here.point, way.middle);
                Arrival& there = arrivals[static_cast<std::size_t>(way.to)];
                if (next >= there.cost) continue;
                there = {next, leaf, &way, way.middle};
                pending.emplace(next, way.to);
            }
        }
        return kNoLeaf;
    }
};

double distance_to(const Box& box, const glm::dvec3& point)
{
    return glm::length(glm::max(glm::max(box.min - point, point - box.max), glm::dvec3(0.0)));
}

std::string node_near(const Scene& scene, const glm::dvec3& point)
{
    const Object* best = nullptr;
    std::pair<double, double> least;
    for (const Object& object : scene.objects) {
        if (object.bounds_world.is_empty()) continue;
        const std::pair<double, double> here{distance_to(object.bounds_world, point),
                                             glm::length(object.bounds_world.size())};
        if (best != nullptr && here >= least) continue;
        best = &object;
        least = here;
    }
    return best == nullptr ? "" : scene.nodes[static_cast<std::size_t>(best->node)].path;
}

bool covers(const PlanePolygon& polygon, const glm::dvec3& normal, const glm::dvec3& point)
{
    bool has_left = false, has_right = false;
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const glm::dvec3& a = polygon.corners[i];
        const glm::dvec3& b = polygon.corners[(i + 1) % polygon.corners.size()];
        const double side = glm::dot(glm::cross(b - a, point - a), normal);
        has_left |= side > 0.0;
        has_right |= side < 0.0;
    }
    return !(has_left && has_right);
}

/// Whether nothing blocks the straight line between two places, in grid units. By rounded numbers: it serves drawing.
bool is_free(const BspBuild& build, int child, const glm::dvec3& from, const glm::dvec3& to)
{
    if (child < 0) return true;
    const BspNode& node = build.tree.nodes[static_cast<std::size_t>(child)];
    const double at_from = node.plane.distance(from);
    const double at_to = node.plane.distance(to);
    if ((at_from > 0.0) == (at_to > 0.0)) return is_free(build, at_from > 0.0 ? node.front : node.back, from, to);
    const glm::dvec3 middle = from + (to - from) * (at_from / (at_from - at_to));
    for (const BlockingPolygon& polygon : build.polygons_of_node[static_cast<std::size_t>(child)]) {
        const bool blocks = at_from > 0.0 ? polygon.blocks_from_front : polygon.blocks_from_back;
        if (blocks && covers(polygon.polygon, node.plane.unit_normal, middle)) return false;
    }
    return is_free(build, at_from > 0.0 ? node.front : node.back, from, middle) &&
           is_free(build, at_from > 0.0 ? node.back : node.front, middle, to);
}

/// The same way with fewer corners; those at `kept` stay.
std::vector<glm::dvec3> straightened(const BspBuild& build, const std::vector<glm::dvec3>& points, std::size_t kept)
{
    const auto in_grid = [&](const glm::dvec3& p) {
        return (p - build.tree.grid.origin_world) / build.tree.grid.step_m;
    };
    const int root = build.tree.nodes.empty() ? ~0 : 0;
    std::vector<glm::dvec3> result{points.front()};
    for (std::size_t at = 0; at + 1 < points.size();) {
        std::size_t next = at < kept ? kept : points.size() - 1;
        while (next > at + 1 && !is_free(build, root, in_grid(points[at]), in_grid(points[next]))) --next;
        result.push_back(points[next]);
        at = next;
    }
    return result;
}

Leak leak_along(const Search& search, int outside, const InsidePlace& place, const Scene& scene)
{
    Leak leak;
    leak.from = place.name;
    const Way* narrowest = nullptr;
    int leaf = outside;
    for (; search.arrivals[static_cast<std::size_t>(leaf)].way != nullptr;
         leaf = search.arrivals[static_cast<std::size_t>(leaf)].from) {
        const Way& way = *search.arrivals[static_cast<std::size_t>(leaf)].way;
        if (leak.points_world.empty()) leak.points_world.push_back(way.middle + kMargin_m * way.out);
        leak.points_world.push_back(way.middle);
        if (narrowest == nullptr || way.area_m2 < narrowest->area_m2) narrowest = &way;
    }
    leak.points_world.push_back(place.position_world);
    std::reverse(leak.points_world.begin(), leak.points_world.end());
    leak.opening_world = narrowest == nullptr ? place.position_world : narrowest->middle;
    const auto hole = std::find(leak.points_world.begin(), leak.points_world.end(), leak.opening_world);
    leak.points_world =
        straightened(search.rooms.build, leak.points_world, static_cast<std::size_t>(hole - leak.points_world.begin()));
    leak.opening_m2 = narrowest == nullptr ? 0.0 : narrowest->area_m2;
    leak.near_node = node_near(scene, leak.opening_world);
    return leak;
}

}  // namespace

std::vector<InsidePlace> inside_places(const Level& level)
{
    if (level.start) return {{"start", level.start->position}};
    std::vector<InsidePlace> places;
    for (const Camera& camera : level.cameras) places.push_back({"camera " + camera.name, camera.eye_world});
    if (!places.empty()) return places;
    for (const CameraPath& path : level.paths)
        for (const PathKey& key : path.keys) places.push_back({"path " + path.name, key.position});
    return places;
}

LeakSearch find_leaks(const Scene& scene, const Level& level, std::span<const InsidePlace> places, int most)
{
    const Rooms rooms = make_rooms(scene, level);
    LeakSearch result;
    result.is_complete = rooms.are_complete;
    std::vector<Leak>& leaks = result.leaks;
    std::vector<Hole> told;
    for (const InsidePlace& place : places) {
        const int start = leaf_at(rooms.build.tree, place.position_world);
        if (start == kNoLeaf) {
            leaks.push_back({place.name, {place.position_world}, place.position_world, 0.0, ""});
            continue;
        }
        while (static_cast<int>(leaks.size()) < most) {
            Search widest{.rooms = rooms, .told = told, .wants_wide = true, .arrivals = {}};
            const int outside = widest.run(start, place.position_world);
            if (outside == kNoLeaf) break;
            const double width = -widest.arrivals[static_cast<std::size_t>(outside)].cost;
            Search shortest{.rooms = rooms, .told = told, .least_m2 = width, .arrivals = {}};
            const int end = shortest.run(start, place.position_world);
            leaks.push_back(leak_along(shortest, end == kNoLeaf ? outside : end, place, scene));
            if (leaks.back().points_world.size() < 2 || leaks.back().opening_m2 <= 0.0) break;
            told.push_back(
                {leaks.back().opening_world, std::max(kLeastHoleReach_m, 1.5 * std::sqrt(leaks.back().opening_m2))});
        }
    }
    return result;
}

}  // namespace hw
