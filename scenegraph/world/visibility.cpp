#include "world/visibility.hpp"

#include <algorithm>
#include <chrono>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>
#include <numeric>

#include "world/portals.hpp"
#include "world/structure.hpp"

namespace hw {
namespace {

/// How far a drawn triangle may lie from its snapped copy, and a little.
double registration_slack_m(const Grid& grid) { return std::max(4.0 * grid.step_m, 3e-5); }

void make_slots(const Scene& scene, std::span<const MeshChunks> chunks_of_mesh, Visibility& visibility)
{
    visibility.first_slot_of_object.push_back(0);
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const MeshChunks& chunks = chunks_of_mesh[static_cast<std::size_t>(scene.objects[id].mesh)];
        for (std::uint32_t chunk = 0; chunk < chunks.size(); ++chunk) visibility.slots.push_back({id, chunk});
        visibility.first_slot_of_object.push_back(static_cast<std::uint32_t>(visibility.slots.size()));
    }
}

/// The clusters whose open leaves the triangles of a chunk touch, ascending. An animated object is everywhere.
std::vector<int> clusters_of_slot(const Scene& scene, std::span<const MeshChunks> chunks_of_mesh, const BspTree& tree,
                                const ChunkSlot& slot)
{
    std::vector<int> clusters;
    const Object& object = scene.objects[slot.object];
    if (scene.nodes[static_cast<std::size_t>(object.node)].is_animated) {
        clusters.resize(static_cast<std::size_t>(tree.cluster_count));
        std::iota(clusters.begin(), clusters.end(), 0);
        return clusters;
    }
    const std::size_t mesh_index = static_cast<std::size_t>(object.mesh);
    const MeshData& mesh = scene.meshes[mesh_index];
    const MeshChunk& chunk = chunks_of_mesh[mesh_index][slot.chunk];
    const glm::dmat4& matrix = scene.world_from_object(slot.object);
    const bool is_double_sided = scene.materials[static_cast<std::size_t>(object.material)].is_double_sided;
    const double facing_sign = is_double_sided ? 0.0 : glm::determinant(glm::dmat3(matrix)) < 0.0 ? -1.0 : 1.0;
    const double slack_m = registration_slack_m(tree.grid);
    std::vector<int> leaves;
    for (std::uint32_t i = 0; i < chunk.index_count; i += 3) {
        std::array<glm::dvec3, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = mesh.indices[chunk.first_index + i + k];
            corners[k] = glm::dvec3(matrix * glm::dvec4(glm::dvec3(mesh.positions[vertex]), 1.0));
        }
        const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double length = glm::length(normal);
        const glm::dvec3 facing = length > 0.0 ? normal * (facing_sign / length) : glm::dvec3(0.0);
        leaves_of_polygon(tree, corners, facing, slack_m, leaves);
    }
    for (const int leaf : leaves) {
        const std::size_t index = static_cast<std::size_t>(leaf);
        if (!tree.is_solid[index]) clusters.push_back(tree.cluster_of_leaf[index]);
    }
    std::sort(clusters.begin(), clusters.end());
    clusters.erase(std::unique(clusters.begin(), clusters.end()), clusters.end());
    return clusters;
}

void register_slots(const Scene& scene, std::span<const MeshChunks> chunks_of_mesh, Visibility& visibility)
{
    std::vector<std::vector<std::uint32_t>> slots_of_cluster(static_cast<std::size_t>(visibility.tree.cluster_count));
    for (std::uint32_t slot = 0; slot < visibility.slots.size(); ++slot) {
        for (const int cluster : clusters_of_slot(scene, chunks_of_mesh, visibility.tree, visibility.slots[slot])) {
            slots_of_cluster[static_cast<std::size_t>(cluster)].push_back(slot);
        }
    }
    visibility.first_in_cluster.push_back(0);
    for (const std::vector<std::uint32_t>& slots : slots_of_cluster) {
        visibility.slots_of_cluster.insert(visibility.slots_of_cluster.end(), slots.begin(), slots.end());
        visibility.first_in_cluster.push_back(static_cast<std::uint32_t>(visibility.slots_of_cluster.size()));
    }
}

/// Calls visit(leaf) for each set bit.
template <typename Visit>
void visit_bits(std::span<const std::uint64_t> words, const Visit& visit)
{
    for (std::size_t word = 0; word < words.size(); ++word) {
        for (std::uint64_t bits = words[word]; bits != 0; bits &= bits - 1) {
            visit(static_cast<int>(word * 64) + __builtin_ctzll(bits));
        }
    }
}

void show_cluster(const Visibility& visibility, int cluster, std::vector<std::uint8_t>& is_visible)
{
    const std::size_t index = static_cast<std::size_t>(cluster);
    for (std::uint32_t i = visibility.first_in_cluster[index]; i < visibility.first_in_cluster[index + 1]; ++i) {
        is_visible[visibility.slots_of_cluster[i]] = 1;
    }
}

/// For each cluster, whether a leaf of it is not solid.
std::vector<std::uint8_t> open_clusters(const BspTree& tree)
{
    std::vector<std::uint8_t> result(static_cast<std::size_t>(tree.cluster_count));
    for (std::size_t leaf = 0; leaf < tree.is_solid.size(); ++leaf) {
        if (!tree.is_solid[leaf]) result[static_cast<std::size_t>(tree.cluster_of_leaf[leaf])] = 1;
    }
    return result;
}

double average_visible_share(const Scene& scene, std::span<const MeshChunks> chunks_of_mesh, const Visibility& visibility)
{
    std::vector<double> triangles;
    for (const ChunkSlot& slot : visibility.slots) {
        const std::size_t mesh = static_cast<std::size_t>(scene.objects[slot.object].mesh);
        triangles.push_back(chunks_of_mesh[mesh][slot.chunk].index_count / 3.0);
    }
    const std::vector<std::uint8_t> is_open = open_clusters(visibility.tree);
    const auto open_count = std::count(is_open.begin(), is_open.end(), std::uint8_t{1});
    const double total = std::accumulate(triangles.begin(), triangles.end(), 0.0);
    if (total == 0.0 || open_count == 0) return 1.0;
    double sum = 0.0;
    std::vector<std::uint8_t> is_visible(visibility.slots.size());
    for (int cluster = 0; cluster < visibility.tree.cluster_count; ++cluster) {
        if (!is_open[static_cast<std::size_t>(cluster)]) continue;
        std::fill(is_visible.begin(), is_visible.end(), std::uint8_t{0});
        visit_bits(visibility.rows.row(cluster), [&](int seen) { show_cluster(visibility, seen, is_visible); });
        for (std::size_t slot = 0; slot < is_visible.size(); ++slot) sum += is_visible[slot] ? triangles[slot] : 0.0;
    }
    return sum / total / static_cast<double>(open_count);
}

BspBuild build_tree(const Scene& scene, const Level& level, const VisibilityOptions& options, VisibilityStats& stats)
{
    StructureOptions structure_options;
    structure_options.max_structure = options.max_structure_polygons;
    structure_options.max_details = options.max_detail_polygons;
    structure_options.least_area_share = options.least_area_share;
    Structure structure = choose_structure(scene, level, structure_options);
    while (true) {
        BspBuild build =
            build_bsp(structure.grid, structure.planes, structure.polygons, structure.box_min, structure.box_max);
        stats.structure_polygons = structure.structure_count;
        stats.detail_polygons = static_cast<int>(structure.polygons.size()) - structure.structure_count;
        if (build.tree.cluster_count <= options.max_clusters || structure.structure_count < 2) return build;
        const int kept = structure.structure_count * 2 / 3;
        for (int i = kept; i < structure.structure_count; ++i) structure.polygons[static_cast<std::size_t>(i)].is_detail = true;
        structure.structure_count = kept;
    }
}

/// The union of the rows that an eye needs; empty where it sees everything.
std::vector<std::uint64_t> seen_clusters(const Visibility& visibility, const glm::dvec3& eye_world, double radius_m)
{
    const std::vector<int> leaves = leaves_near(visibility.tree, eye_world, radius_m);
    const int own = leaf_at(visibility.tree, eye_world);
    if (leaves.empty() || own < 0 || visibility.tree.is_solid[static_cast<std::size_t>(own)]) return {};
    std::vector<std::uint64_t> seen(visibility.rows.row(0).size());
    for (const int leaf : leaves) {
        // What is solid shows nothing to an eye outside of it: its faces look the other way.
        if (visibility.tree.is_solid[static_cast<std::size_t>(leaf)]) continue;
        const auto row = visibility.rows.row(visibility.tree.cluster_of_leaf[static_cast<std::size_t>(leaf)]);
        for (std::size_t word = 0; word < seen.size(); ++word) seen[word] |= row[word];
    }
    return seen;
}

}  // namespace

Visibility build_visibility(const Scene& scene, const Level& level, std::span<const MeshChunks> chunks_of_mesh,
                            const VisibilityOptions& options)
{
    const auto start = std::chrono::steady_clock::now();
    Visibility visibility;
    make_slots(scene, chunks_of_mesh, visibility);
    BspBuild build = build_tree(scene, level, options, visibility.stats);
    const PortalGraph graph = build_portals(build);
    visibility.tree = std::move(build.tree);
    PvsOptions pvs_options;
    pvs_options.effort = options.effort;
    pvs_options.seconds = options.flow_seconds;
    pvs_options.threads = options.threads;
    PvsResult pvs = build_pvs(graph, pvs_options);
    visibility.rows = std::move(pvs.rows);
    register_slots(scene, chunks_of_mesh, visibility);

    VisibilityStats& stats = visibility.stats;
    const std::vector<std::uint8_t>& is_solid = visibility.tree.is_solid;
    stats.leaves = visibility.tree.leaf_count;
    stats.solid_leaves = static_cast<int>(std::count(is_solid.begin(), is_solid.end(), std::uint8_t{1}));
    stats.clusters = visibility.tree.cluster_count;
    stats.portals = static_cast<int>(graph.portals.size());
    stats.coarse_portals = pvs.coarse_portals;
    stats.average_visible_share = average_visible_share(scene, chunks_of_mesh, visibility);
    stats.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return visibility;
}

void visible_chunks(const Visibility& visibility, const glm::dvec3& eye_world, double near_radius_m,
                    std::vector<std::uint8_t>& is_visible_by_chunk_slot)
{
    const std::vector<std::uint64_t> seen = seen_clusters(visibility, eye_world, near_radius_m);
    is_visible_by_chunk_slot.assign(visibility.slots.size(), seen.empty() ? 1 : 0);
    visit_bits(seen, [&](int cluster) { show_cluster(visibility, cluster, is_visible_by_chunk_slot); });
}

int visible_leaf_count(const Visibility& visibility, const glm::dvec3& eye_world, double near_radius_m)
{
    const std::vector<std::uint64_t> seen = seen_clusters(visibility, eye_world, near_radius_m);
    if (seen.empty()) return visibility.tree.cluster_count;
    int count = 0;
    for (const std::uint64_t word : seen) count += __builtin_popcountll(word);
    return count;
}

}  // namespace hw
