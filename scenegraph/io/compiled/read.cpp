// Everything here is checked although the hash holds: it finds damage, not a file that was made to deceive.
#include "hatchway/io/compiled/read.hpp"

#include <compiled_level_generated.h>

#include <cmath>
#include <cstring>

#include "hatchway/core/error.hpp"
#include "hatchway/core/hash.hpp"
#include "hatchway/core/limits.hpp"
#include "hatchway/io/compiled/packed_rows.hpp"

namespace hw {
namespace {

constexpr std::int64_t kMostNormal = std::int64_t{1} << 58;      // bounds of ExactPlane
constexpr std::int64_t kMostOffsetHigh = std::int64_t{1} << 23;  // 2^87 over 2^64
constexpr std::uint32_t kMostClusters = 20'000;
constexpr std::uint32_t kLeastCorners = 3;
constexpr double kMostMetres = 1e9;  // of portals, from the grid's origin: far more than a grid reaches

/// Checks one stored world and makes a visibility of it.
class WorldReader {
 public:
    WorldReader(const stored::World& world, const Scene& scene, std::span<const MeshChunks> chunks_of_mesh,
                const std::string& file)
        : world_(world), scene_(scene), chunks_of_mesh_(chunks_of_mesh), file_(file)
    {
    }

    CompiledLevel read()
    {
        CompiledLevel level;
        require(world_.effort() <= static_cast<std::uint8_t>(PvsEffort::exact), "the effort is unknown");
        level.effort = static_cast<PvsEffort>(world_.effort());
        Visibility& visibility = level.visibility;
        check_alignment();
        check_chunks();
        number_slots(scene_, chunks_of_mesh_, visibility);
        read_leaves(visibility.tree);
        read_nodes(visibility.tree);
        const int clusters = visibility.tree.cluster_count;
        visibility.rows = rows(*world_.cluster_rows(), clusters, clusters);
        visibility.slot_rows = rows(*world_.slot_rows(), clusters, static_cast<int>(visibility.slots.size()));
        read_portals(visibility.portals);
        for (const stored::Space* space : *world_.cluster_boxes()) visibility.cluster_boxes.push_back(box(*space));
        read_stats(visibility);
        return level;
    }

 private:
    void require(bool holds, const char* what) const
    {
        if (!holds) throw Error({.what = what, .file = file_, .expected = "a compiled level that is not damaged"});
    }

    glm::dvec3 point(const stored::Point& p, double most) const
    {
        const glm::dvec3 result(p.x(), p.y(), p.z());
        for (int axis = 0; axis < 3; ++axis)
            require(std::abs(result[axis]) <= most, "a place is no number, or far off");
        return result;
    }

    Box box(const stored::Space& space) const
    {
        const Box result{point(space.min(), 2.0 * limits::kMaxCoordinate),
                         point(space.max(), 2.0 * limits::kMaxCoordinate)};
        return result.is_empty() ? Box() : result;
    }

    /// The verifier lets elements of 8 bytes start at any 4.
    void check_alignment() const
    {
        const auto is_aligned = [](const auto* vector) {
            return vector->size() == 0 || reinterpret_cast<std::uintptr_t>(vector->Data()) % alignof(double) == 0;
        };
        require(is_aligned(world_.planes()) && is_aligned(world_.portals()) && is_aligned(world_.portal_corners()) &&
                    is_aligned(world_.cluster_boxes()),
                "numbers start where none may stand");
    }

    void check_chunks() const
    {
        require(world_.chunk_counts()->size() == chunks_of_mesh_.size(), "the scene has another number of meshes");
        for (std::size_t i = 0; i < chunks_of_mesh_.size(); ++i)
            require(world_.chunk_counts()->Get(static_cast<std::uint32_t>(i)) == chunks_of_mesh_[i].size(),
                    "a mesh is cut into another number of chunks");
    }

    void read_leaves(BspTree& tree) const
    {
        tree.grid.origin_world = point(*world_.grid_origin(), 2.0 * limits::kMaxCoordinate);
        tree.grid.step_m = world_.grid_step_m();
        int exponent = 0;
        const bool is_power = std::frexp(tree.grid.step_m, &exponent) == 0.5;
        // A scene of no extent has the least step, 2^-113.
        require(is_power && exponent >= -128 && exponent < 64, "the grid's step is impossible");
        tree.bounds_world = box(*world_.bounds());
        require(!tree.bounds_world.is_empty(), "the bounds are impossible");
        const std::uint32_t leaves = world_.cluster_of_leaf()->size();
        require(leaves == static_cast<std::uint64_t>(world_.nodes()->size()) + 1,
                "the tree has another number of leaves");
        require(world_.cluster_boxes()->size() >= 1 && world_.cluster_boxes()->size() <= kMostClusters,
                "the number of clusters is impossible");
        tree.leaf_count = static_cast<int>(leaves);
        tree.cluster_count = static_cast<int>(world_.cluster_boxes()->size());
        require(world_.is_solid()->size() == (leaves + 7u) / 8u, "solid leaves are not all told");
        for (std::uint32_t leaf = 0; leaf < leaves; ++leaf) {
            const std::uint32_t cluster = world_.cluster_of_leaf()->Get(leaf);
            require(cluster < world_.cluster_boxes()->size(), "a leaf is of no cluster");
            tree.cluster_of_leaf.push_back(static_cast<int>(cluster));
            tree.is_solid.push_back(world_.is_solid()->Get(leaf / 8) >> (leaf % 8) & 1);
        }
    }

    ExactPlane plane(const stored::Plane& p) const
    {
        const std::array<std::int64_t, 3> normal{p.normal_x(), p.normal_y(), p.normal_z()};
        for (const std::int64_t n : normal)
            require(n > -kMostNormal && n < kMostNormal, "a plane's normal is too large");
        require(normal != std::array<std::int64_t, 3>{}, "a plane has no normal");
        require(p.offset_high() >= -kMostOffsetHigh && p.offset_high() < kMostOffsetHigh, "a plane is too far off");
        const Int128 offset = static_cast<Int128>(
            static_cast<unsigned __int128>(static_cast<std::uint64_t>(p.offset_high())) << 64 | p.offset_low());
        ExactPlane result = make_plane(normal, offset);
        require(result.normal == normal && result.offset == offset, "a plane is not in lowest terms");
        return result;
    }

    /// Each node but the first and each leaf has one parent that stands before it: so they are one tree.
    void read_nodes(BspTree& tree) const
    {
        std::vector<ExactPlane> planes;
        for (const stored::Plane* p : *world_.planes()) planes.push_back(plane(*p));
        const std::size_t count = world_.nodes()->size();
        std::vector<int> depth(count, -1);
        std::vector<std::uint8_t> has_leaf(static_cast<std::size_t>(tree.leaf_count));
        if (count > 0) depth[0] = 0;
        tree.nodes.reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            const stored::Node& node = *world_.nodes()->Get(static_cast<std::uint32_t>(i));
            require(node.plane() < planes.size(), "a node has no plane");
            require(depth[i] >= 0 && depth[i] < kMostTreeDepth, "a node hangs loose, or too deep");
            for (const std::int32_t child : {node.front(), node.back()}) {
                if (child < 0) {
                    require(~child < tree.leaf_count && !has_leaf[static_cast<std::size_t>(~child)],
                            "a leaf is not there, or has two parents");
                    has_leaf[static_cast<std::size_t>(~child)] = 1;
                    continue;
                }
                const std::size_t index = static_cast<std::size_t>(child);
                require(index > i && index < count && depth[index] < 0, "a node is not there, or has two parents");
                depth[index] = depth[i] + 1;
            }
            tree.nodes.push_back({planes[node.plane()], node.front(), node.back()});
        }
    }

    LeafRows rows(const stored::Rows& stored, int row_count, int column_count) const
    {
        require(stored.columns() == static_cast<std::uint32_t>(column_count), "rows have another length");
        auto result = unpack_rows({stored.ends()->data(), stored.ends()->size()},
                                  {stored.bytes()->data(), stored.bytes()->size()}, row_count, column_count);
        require(result.has_value(), "rows are damaged");
        return std::move(*result);
    }

    void read_portals(PortalGraph& graph) const
    {
        const std::uint32_t places = world_.place_count();
        require(places >= 1 && places <= kMostClusters, "the number of places is impossible");
        graph.leaf_count = static_cast<int>(places);
        std::uint64_t at = 0;
        const std::uint64_t corners = world_.portal_corners()->size();
        for (const stored::Portal* p : *world_.portals()) {
            DirectedPortal portal;
            require(p->from() < places && p->to() < places, "a portal leads nowhere");
            require(p->corner_count() >= kLeastCorners && p->corner_count() <= corners - at, "a portal lacks corners");
            portal.from_leaf = static_cast<int>(p->from());
            portal.to_leaf = static_cast<int>(p->to());
            portal.normal = point(p->normal(), 2.0);
            portal.offset = p->offset();
            require(std::abs(portal.offset) <= kMostMetres, "a portal is no plane");
            for (std::uint32_t i = 0; i < p->corner_count(); ++i, ++at)
                portal.winding.push_back(
                    point(*world_.portal_corners()->Get(static_cast<std::uint32_t>(at)), kMostMetres));
            graph.portals.push_back(std::move(portal));
        }
        require(at == corners, "corners of portals are left over");
    }

    void read_stats(Visibility& visibility) const
    {
        const stored::Figures& figures = *world_.figures();
        VisibilityStats& stats = visibility.stats;
        stats.structure_polygons = figures.structure_polygons();
        stats.detail_polygons = figures.detail_polygons();
        stats.portals = figures.portals();
        stats.coarse_portals = figures.coarse_portals();
        stats.average_visible_share = figures.visible_share();
        require(stats.average_visible_share >= 0.0 && stats.average_visible_share <= 1.0, "the figures are impossible");
        stats.leaves = visibility.tree.leaf_count;
        stats.clusters = visibility.tree.cluster_count;
        for (const std::uint8_t is_solid : visibility.tree.is_solid) stats.solid_leaves += is_solid;
    }

    const stored::World& world_;
    const Scene& scene_;
    std::span<const MeshChunks> chunks_of_mesh_;
    const std::string& file_;
};

template <typename Root>
const Root* verified(std::span<const std::uint8_t> bytes, const char* identifier)
{
    constexpr std::uint32_t kMostDepth = 8;
    constexpr std::uint32_t kMostTables = 16;
    if (bytes.size() < 16 || bytes.size() >= FLATBUFFERS_MAX_BUFFER_SIZE) return nullptr;
    flatbuffers::Verifier verifier(bytes.data(), bytes.size(), kMostDepth, kMostTables);
    return verifier.VerifyBuffer<Root>(identifier) ? flatbuffers::GetRoot<Root>(bytes.data()) : nullptr;
}

}  // namespace

CompiledLevel compiled_level_from_bytes(std::span<const std::byte> bytes, const Scene& scene,
                                        std::span<const MeshChunks> chunks_of_mesh, const std::string& file)
{
    const auto refuse = [&](const char* what) {
        return Error({.what = what, .file = file, .expected = "a compiled level that is not damaged"});
    };
    // Copies of our own start where any number may stand.
    std::vector<std::uint8_t> whole(bytes.size());
    if (!bytes.empty()) std::memcpy(whole.data(), bytes.data(), bytes.size());
    const auto* outer = verified<stored::CompiledLevel>(whole, stored::CompiledLevelIdentifier());
    if (outer == nullptr) throw refuse("this is no compiled level");
    if (outer->version() != kCompiledLevelVersion) throw refuse("this is a compiled level of another version");
    const std::vector<std::uint8_t> content(outer->world()->begin(), outer->world()->end());
    if (outer->hash() != hash_bytes(std::as_bytes(std::span(content)))) throw refuse("the compiled level is damaged");
    const auto* world = verified<stored::World>(content, nullptr);
    if (world == nullptr) throw refuse("the compiled level is damaged");
    CompiledLevel level = WorldReader(*world, scene, chunks_of_mesh, file).read();
    level.key = outer->key();
    return level;
}

}  // namespace hw
