#include "hatchway/world/visibility/visibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <glm/common.hpp>
#include <limits>
#include <numeric>

#include "hatchway/world/visibility/rows/leaf_clusters.hpp"
#include "hatchway/world/visibility/rows/shaft_rows.hpp"
#include "hatchway/world/visibility/rows/sight_slices.hpp"
#include "hatchway/world/visibility/tree/portals.hpp"
#include "hatchway/world/visibility/tree/structure.hpp"

namespace hw {
namespace {

constexpr double kPartFactor = 1.5;  // of the side of a cube, where the box is shared out among the cells evenly

/// For each cell, whether sight enters or leaves its cluster: pockets that overlapping objects shut in are no places.
std::vector<std::uint8_t> open_cells(const PortalGraph& graph, std::span<const int> cluster_of_cell)
{
    std::vector<std::uint8_t> is_open(static_cast<std::size_t>(graph.leaf_count));
    for (const DirectedPortal& portal : graph.portals) {
        is_open[static_cast<std::size_t>(portal.from_leaf)] = 1;
        is_open[static_cast<std::size_t>(portal.to_leaf)] = 1;
    }
    std::vector<std::uint8_t> result;
    for (const int cluster : cluster_of_cell) result.push_back(is_open[static_cast<std::size_t>(cluster)]);
    return result;
}

/// What cells see of each other is what their clusters do.
LeafRows rows_of_cells(const LeafRows& clusters, std::span<const int> cluster_of_cell)
{
    const int count = static_cast<int>(cluster_of_cell.size());
    LeafRows cells_of_cluster(clusters.leaf_count(), count);
    for (int cell = 0; cell < count; ++cell)
        cells_of_cluster.show(cluster_of_cell[static_cast<std::size_t>(cell)], cell);
    LeafRows rows(count, count);
    for (int cell = 0; cell < count; ++cell) {
        const std::span<std::uint64_t> row = rows.row(cell);
        visit_bits(clusters.row(cluster_of_cell[static_cast<std::size_t>(cell)]), [&](int seen) {
            const auto cells = cells_of_cluster.row(seen);
            for (std::size_t word = 0; word < row.size(); ++word) row[word] |= cells[word];
        });
    }
    return rows;
}

double average_visible_share(const Scene& scene, std::span<const MeshChunks> chunks_of_mesh,
                             const Visibility& visibility, std::span<const std::uint8_t> is_open)
{
    std::vector<double> triangles;
    for (const ChunkSlot& slot : visibility.slots) {
        const std::size_t mesh = static_cast<std::size_t>(scene.objects[slot.object].mesh);
        triangles.push_back(chunks_of_mesh[mesh][slot.chunk].index_count / 3.0);
    }
    const auto open_count = std::count(is_open.begin(), is_open.end(), std::uint8_t{1});
    const double total = std::accumulate(triangles.begin(), triangles.end(), 0.0);
    if (total == 0.0 || open_count == 0) return 1.0;
    double sum = 0.0;
    for (int cluster = 0; cluster < visibility.tree.cluster_count; ++cluster) {
        if (!is_open[static_cast<std::size_t>(cluster)]) continue;
        visit_bits(visibility.slot_rows.row(cluster),
                   [&](int slot) { sum += triangles[static_cast<std::size_t>(slot)]; });
    }
    return sum / total / static_cast<double>(open_count);
}

/// The cube root of a number above 0, by Newton's steps from above until they no longer fall: the same bits on every
/// machine, which std::cbrt does not promise.
double cube_root(double number)
{
    double root = std::max(number, 1.0);
    while (true) {
        const double next = (2.0 * root + number / (root * root)) / 3.0;
        if (!(next < root)) return root;
        root = next;
    }
}

/// Cells of even size, about as many as there may be; of a flat scene they are flat. A scene without extent has one.
double longest_cell_m(const Scene& scene, const Grid& grid, const VisibilityOptions& options)
{
    constexpr double kLeastSideShare = 1.0 / 64.0;
    constexpr double kLeastSteps = 128.0;  // of the tree's box
    const glm::dvec3 size = scene.bounds_world.is_empty() ? glm::dvec3(0.0) : scene.bounds_world.size();
    const double longest = std::max({size.x, size.y, size.z});
    if (!(longest > 0.0)) return std::numeric_limits<double>::infinity();
    const glm::dvec3 sides = glm::max(size, glm::dvec3(std::max(kLeastSideShare * longest, kLeastSteps * grid.step_m)));
    return kPartFactor * cube_root(sides.x * sides.y * sides.z / options.max_cells);
}

void add_shortfall(std::span<const glm::dvec3> places_world, std::string what, const Box& bounds_world,
                   VisibilityStats& stats)
{
    if (!places_world.empty()) stats.shortfalls.push_back({std::move(what), densest_part(places_world, bounds_world)});
}

void note_demoted(const Structure& structure, const VisibilityOptions& options, const Box& bounds_world,
                  VisibilityStats& stats)
{
    const std::size_t demoted = structure.demoted_world.size();
    add_shortfall(
        structure.demoted_world,
        fmt::format("{} of {} polygons in large planes part no clusters, the budget is {}", demoted,
                    demoted + static_cast<std::size_t>(structure.structure_count), options.max_structure_polygons),
        bounds_world, stats);
}

/// Walls that part places ask for clusters, a seventh of their number in plain rooms; open scenes of many small pieces
/// do not gain by more than the first thousand, and their flow would run out of time.
int cluster_budget(const VisibilityOptions& options, const VisibilityStats& stats)
{
    constexpr int kAlways = 1000, kPolygonsOfCluster = 7;
    return std::min(options.max_clusters, std::max(kAlways, stats.structure_polygons / kPolygonsOfCluster));
}

/// `places` are those of merge_clusters().
void note_merged(std::vector<glm::dvec3> places, const BspTree& tree, int most_clusters, VisibilityStats& stats)
{
    for (glm::dvec3& place : places) place += tree.grid.origin_world;
    add_shortfall(places,
                  fmt::format("{} of {} clusters were merged with others, the budget is {}", places.size(),
                              places.size() + static_cast<std::size_t>(tree.cluster_count), most_clusters),
                  tree.bounds_world, stats);
}

void note_coarse(const PvsResult& pvs, const PortalGraph& graph, const BspTree& tree, VisibilityStats& stats)
{
    std::vector<glm::dvec3> places;
    for (const int portal : pvs.coarse_portals)
        places.push_back(tree.grid.origin_world + graph.portals[static_cast<std::size_t>(portal)].winding[0]);
    add_shortfall(
        places,
        fmt::format("{} of {} openings keep a coarse answer, for want of time", places.size(), graph.portals.size()),
        tree.bounds_world, stats);
}

/// The union of the rows (of clusters or of slots) of leaves, but for solid ones: what is solid shows nothing to an eye
/// outside of it, its faces look the other way.
std::vector<std::uint64_t> union_of_rows(const BspTree& tree, const LeafRows& rows, std::span<const int> leaves)
{
    std::vector<std::uint64_t> seen(rows.row(0).size());
    for (const int leaf : leaves) {
        if (tree.is_solid[static_cast<std::size_t>(leaf)]) continue;
        const auto row = rows.row(tree.cluster_of_leaf[static_cast<std::size_t>(leaf)]);
        for (std::size_t word = 0; word < seen.size(); ++word) seen[word] |= row[word];
    }
    return seen;
}

/// The leaves that an eye needs; none where it sees everything.
std::vector<int> leaves_of_eye(const BspTree& tree, const glm::dvec3& eye_world, double radius_m)
{
    std::vector<int> leaves = leaves_near(tree, eye_world, radius_m);
    const int own = leaf_at(tree, eye_world);
    if (own < 0 || tree.is_solid[static_cast<std::size_t>(own)]) leaves.clear();
    return leaves;
}

/// The leaves that a pane touches; none where it reaches out of the tree's box or lies in walls alone.
std::vector<int> leaves_of_pane(const BspTree& tree, std::span<const glm::dvec3> outline_world)
{
    // The structure was snapped to the grid, the pane was not.
    const double slack_m = 2.0 * tree.grid.step_m;
    std::vector<int> leaves;
    for (const glm::dvec3& corner : outline_world)
        if (leaf_at(tree, corner) < 0) return {};
    for (std::size_t i = 2; i < outline_world.size(); ++i) {
        const std::array triangle{outline_world[0], outline_world[i - 1], outline_world[i]};
        leaves_of_polygon(tree, triangle, glm::dvec3(0.0), slack_m, leaves);
    }
    const bool is_in_walls =
        std::ranges::all_of(leaves, [&](int leaf) { return tree.is_solid[static_cast<std::size_t>(leaf)] != 0; });
    if (is_in_walls) leaves.clear();
    return leaves;
}

void mark_chunks(const Visibility& visibility, std::span<const int> leaves, std::vector<std::uint8_t>& is_visible)
{
    is_visible.assign(visibility.slots.size(), leaves.empty() ? 1 : 0);
    if (leaves.empty()) return;
    visit_bits(union_of_rows(visibility.tree, visibility.slot_rows, leaves),
               [&](int slot) { is_visible[static_cast<std::size_t>(slot)] = 1; });
}

}  // namespace

void number_slots(const Scene& scene, std::span<const MeshChunks> chunks_of_mesh, Visibility& visibility)
{
    visibility.first_slot_of_object.push_back(0);
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const MeshChunks& chunks = chunks_of_mesh[static_cast<std::size_t>(scene.objects[id].mesh)];
        for (std::uint32_t chunk = 0; chunk < chunks.size(); ++chunk) visibility.slots.push_back({id, chunk});
        visibility.first_slot_of_object.push_back(static_cast<std::uint32_t>(visibility.slots.size()));
    }
}

BspBuild build_sight_tree(const Scene& scene, const Level& level, const VisibilityOptions& options,
                          VisibilityStats& stats, double& area_m2)
{
    StructureOptions structure_options;
    structure_options.max_structure = options.max_structure_polygons;
    structure_options.max_details = options.max_detail_polygons;
    structure_options.least_area_share = options.least_area_share;
    Structure structure = choose_structure(scene, level, structure_options);
    area_m2 = structure.area_m2;
    stats.structure_polygons = structure.structure_count;
    stats.detail_polygons = static_cast<int>(structure.polygons.size()) - structure.structure_count;
    note_demoted(structure, options, scene.bounds_world, stats);
    const std::size_t polygon_count = structure.polygons.size();
    BspBuild build = build_bsp(structure.grid, std::move(structure.planes), std::move(structure.polygons),
                               structure.box_min, structure.box_max, longest_cell_m(scene, structure.grid, options));
    if (build.left_out > 0)
        stats.shortfalls.push_back(
            {fmt::format(
                 "{} of {} polygons block no sight: their planes part space into more cells than there is room for",
                 build.left_out, polygon_count),
             scene.bounds_world});
    return build;
}

Visibility build_visibility(const Scene& scene, const Level& level, std::span<const MeshChunks> chunks_of_mesh,
                            const VisibilityOptions& options)
{
    const auto start = std::chrono::steady_clock::now();
    const auto tell = [&](double share) { return options.progress ? options.progress(share) : void(); };
    Visibility visibility;
    number_slots(scene, chunks_of_mesh, visibility);
    double area_m2 = 0.0;
    BspBuild build = build_sight_tree(scene, level, options, visibility.stats, area_m2);
    tell(0.1);
    const std::vector<LeafContact> contacts = leaf_contacts(build);
    tell(0.2);
    const int most_clusters = cluster_budget(options, visibility.stats);
    note_merged(merge_clusters(build.tree, contacts, {.most = most_clusters}), build.tree, most_clusters,
                visibility.stats);
    const PortalGraph graph = cluster_portals(build, contacts);
    const std::vector<Box> boxes_of_leaves = leaf_boxes(build.tree, contacts);
    const SightSlices slices(build, contacts, boxes_of_leaves, {.threads = options.threads});
    const std::vector<int> cluster_of_cell = split_into_cells(build, contacts, {.most = options.max_cells});
    visibility.portals = cluster_portals(build, contacts);
    visibility.tree = std::move(build.tree);
    tell(0.3);
    PvsOptions pvs_options;
    pvs_options.effort = options.effort;
    pvs_options.seconds = options.flow_seconds;
    pvs_options.threads = options.threads;
    if (options.progress) pvs_options.progress = [&](double share) { tell(0.3 + 0.4 * share); };
    PvsResult pvs = build_pvs(graph, pvs_options);
    visibility.rows = rows_of_cells(pvs.rows, cluster_of_cell);
    tell(0.7);
    visibility.cluster_boxes = cluster_boxes(visibility.tree, boxes_of_leaves);
    const SlotPlaces places{scene, chunks_of_mesh, visibility.slots, visibility.tree, visibility.cluster_boxes};
    visibility.slot_rows = slots_seen(places, visibility.rows);
    ShaftOptions shaft_options{.threads = options.threads};
    if (options.progress) shaft_options.progress = [&](double share) { tell(0.75 + 0.25 * share); };
    hide_behind_slices(places, slices, boxes_of_leaves, shaft_options, visibility.slot_rows);
    tell(1.0);

    VisibilityStats& stats = visibility.stats;
    const std::vector<std::uint8_t>& is_solid = visibility.tree.is_solid;
    stats.leaves = visibility.tree.leaf_count;
    stats.solid_leaves = static_cast<int>(std::count(is_solid.begin(), is_solid.end(), std::uint8_t{1}));
    stats.clusters = visibility.tree.cluster_count;
    stats.portals = static_cast<int>(graph.portals.size());
    stats.coarse_portals = static_cast<int>(pvs.coarse_portals.size());
    note_coarse(pvs, graph, visibility.tree, stats);
    stats.average_visible_share =
        average_visible_share(scene, chunks_of_mesh, visibility, open_cells(graph, cluster_of_cell));
    stats.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return visibility;
}

void visible_chunks(const Visibility& visibility, const glm::dvec3& eye_world, double near_radius_m,
                    std::vector<std::uint8_t>& is_visible_by_chunk_slot)
{
    mark_chunks(visibility, leaves_of_eye(visibility.tree, eye_world, near_radius_m), is_visible_by_chunk_slot);
}

void chunks_before_pane(const Visibility& visibility, std::span<const glm::dvec3> outline_world,
                        std::vector<std::uint8_t>& is_visible_by_chunk_slot)
{
    mark_chunks(visibility, leaves_of_pane(visibility.tree, outline_world), is_visible_by_chunk_slot);
}

int visible_leaf_count(const Visibility& visibility, const glm::dvec3& eye_world, double near_radius_m)
{
    const std::vector<int> leaves = leaves_of_eye(visibility.tree, eye_world, near_radius_m);
    if (leaves.empty()) return visibility.tree.cluster_count;
    int count = 0;
    for (const std::uint64_t word : union_of_rows(visibility.tree, visibility.rows, leaves))
        count += __builtin_popcountll(word);
    return count;
}

}  // namespace hw
