#include "hatchway/io/compiled/write.hpp"

#include <compiled_level_generated.h>

#include <map>
#include <tuple>

#include "hatchway/core/hash.hpp"
#include "hatchway/io/compiled/packed_rows.hpp"

namespace hw {
namespace {

using flatbuffers::FlatBufferBuilder;
using flatbuffers::Offset;

stored::Point stored_point(const glm::dvec3& p)
{
    return {p.x, p.y, p.z};
}

stored::Space stored_space(const Box& box)
{
    // Without infinities, so that a file holds none.
    if (box.is_empty()) return {{1.0, 1.0, 1.0}, {-1.0, -1.0, -1.0}};
    return {stored_point(box.min), stored_point(box.max)};
}

stored::Plane stored_plane(const ExactPlane& plane)
{
    return {plane.normal[0], plane.normal[1], plane.normal[2], static_cast<std::uint64_t>(plane.offset),
            static_cast<std::int64_t>(plane.offset >> 64)};
}

/// Many nodes share a plane.
struct StoredTree {
    std::vector<stored::Plane> planes;
    std::vector<stored::Node> nodes;
};

StoredTree stored_tree(const BspTree& tree)
{
    StoredTree result;
    std::map<std::tuple<std::array<std::int64_t, 3>, Int128>, std::uint32_t> numbers;
    for (const BspNode& node : tree.nodes) {
        const auto [place, is_new] = numbers.try_emplace({node.plane.normal, node.plane.offset},
                                                         static_cast<std::uint32_t>(result.planes.size()));
        if (is_new) result.planes.push_back(stored_plane(node.plane));
        result.nodes.emplace_back(place->second, node.front, node.back);
    }
    return result;
}

Offset<stored::Rows> stored_rows(FlatBufferBuilder& builder, const LeafRows& rows)
{
    const PackedRows packed = pack_rows(rows);
    return stored::CreateRowsDirect(builder, static_cast<std::uint32_t>(rows.column_count()), &packed.ends,
                                    &packed.bytes);
}

std::vector<std::uint8_t> stored_bits(const std::vector<std::uint8_t>& flags)
{
    std::vector<std::uint8_t> bits((flags.size() + 7) / 8);
    for (std::size_t i = 0; i < flags.size(); ++i) bits[i / 8] |= static_cast<std::uint8_t>((flags[i] & 1) << (i % 8));
    return bits;
}

struct StoredPortals {
    std::vector<stored::Portal> portals;
    std::vector<stored::Point> corners;
};

StoredPortals stored_portals(const PortalGraph& graph)
{
    StoredPortals result;
    for (const DirectedPortal& portal : graph.portals) {
        result.portals.emplace_back(static_cast<std::uint32_t>(portal.from_leaf),
                                    static_cast<std::uint32_t>(portal.to_leaf), stored_point(portal.normal),
                                    portal.offset, static_cast<std::uint32_t>(portal.winding.size()));
        for (const glm::dvec3& corner : portal.winding) result.corners.push_back(stored_point(corner));
    }
    return result;
}

void build_world(FlatBufferBuilder& builder, const CompiledLevel& level, std::span<const MeshChunks> chunks_of_mesh)
{
    const Visibility& visibility = level.visibility;
    const BspTree& tree = visibility.tree;
    const StoredTree nodes = stored_tree(tree);
    const StoredPortals portals = stored_portals(visibility.portals);
    const std::vector<std::uint32_t> clusters(tree.cluster_of_leaf.begin(), tree.cluster_of_leaf.end());
    std::vector<std::uint32_t> chunk_counts;
    for (const MeshChunks& chunks : chunks_of_mesh) chunk_counts.push_back(static_cast<std::uint32_t>(chunks.size()));
    std::vector<stored::Space> boxes;
    for (const Box& box : visibility.cluster_boxes) boxes.push_back(stored_space(box));
    const VisibilityStats& stats = visibility.stats;
    const stored::Figures figures(stats.structure_polygons, stats.detail_polygons, stats.portals, stats.coarse_portals,
                                  stats.average_visible_share);
    const stored::Point origin = stored_point(tree.grid.origin_world);
    const stored::Space bounds = stored_space(tree.bounds_world);
    const auto planes = builder.CreateVectorOfStructs(nodes.planes);
    const auto stored_nodes = builder.CreateVectorOfStructs(nodes.nodes);
    const auto cluster_of_leaf = builder.CreateVector(clusters);
    const auto is_solid = builder.CreateVector(stored_bits(tree.is_solid));
    const auto cluster_rows = stored_rows(builder, visibility.rows);
    const auto slot_rows = stored_rows(builder, visibility.slot_rows);
    const auto counts = builder.CreateVector(chunk_counts);
    const auto stored_portal_list = builder.CreateVectorOfStructs(portals.portals);
    const auto corners = builder.CreateVectorOfStructs(portals.corners);
    const auto cluster_boxes = builder.CreateVectorOfStructs(boxes);
    builder.Finish(stored::CreateWorld(builder, static_cast<std::uint8_t>(level.effort), &origin, tree.grid.step_m,
                                       &bounds, planes, stored_nodes, cluster_of_leaf, is_solid, cluster_rows,
                                       slot_rows, counts, static_cast<std::uint32_t>(visibility.portals.leaf_count),
                                       stored_portal_list, corners, cluster_boxes, &figures));
}

}  // namespace

std::vector<std::byte> compiled_level_bytes(const CompiledLevel& level, std::span<const MeshChunks> chunks_of_mesh)
{
    FlatBufferBuilder world;
    build_world(world, level, chunks_of_mesh);
    const std::span<const std::uint8_t> content(world.GetBufferPointer(), world.GetSize());
    FlatBufferBuilder builder;
    builder.ForceVectorAlignment(content.size(), 1, 8);
    const auto nested = builder.CreateVector(content.data(), content.size());
    builder.Finish(stored::CreateCompiledLevel(builder, kCompiledLevelVersion, level.key,
                                               hash_bytes(std::as_bytes(content)), nested),
                   stored::CompiledLevelIdentifier());
    const auto bytes = std::as_bytes(std::span(builder.GetBufferPointer(), builder.GetSize()));
    return {bytes.begin(), bytes.end()};
}

}  // namespace hw
