#include "hatchway/world/visibility/rows/slot_rows.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "hatchway/world/visibility/rows/slot_triangles.hpp"

namespace hw {
namespace {

/// More triangles than this in one cluster are taken to face every way.
constexpr std::size_t kMostFacings = 256;

/// Where a scene draws more triangles than this, chunks are placed by their boxes.
constexpr std::uint64_t kMostTriangles = 12'000'000;

/// A half-space, in front of a triangle that is drawn from its front only.
struct Facing {
    glm::dvec3 normal{0.0};
    double offset = 0.0;
};

/// A slot in a cluster.
struct Presence {
    std::uint32_t slot = 0;
    bool faces_all = false;
    std::vector<Facing> facings;
};

bool is_partly_in_front(const Box& box, const Facing& facing, double slack)
{
    if (box.is_empty()) return true;
    double most = facing.offset;
    for (int axis = 0; axis < 3; ++axis) {
        most += std::max(facing.normal[axis] * box.min[axis], facing.normal[axis] * box.max[axis]);
    }
    return most > -slack;
}

void add_triangle(const SlotPlaces& places, const SlotTriangle& triangle, std::uint32_t slot,
                  std::vector<std::vector<Presence>>& presences)
{
    const std::array<glm::dvec3, 3>& corners = triangle.corners_world;
    const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double length = glm::length(normal);
    if (!(length > 0.0)) return;  // never drawn
    Facing facing;
    facing.normal = normal * (triangle.facing_sign / length);
    facing.offset = -glm::dot(facing.normal, corners[0]);
    std::vector<int> leaves;
    leaves_of_polygon(places.tree, corners, facing.normal, slack_m(places.tree.grid), leaves);
    int last = -1;
    for (const int leaf : leaves) {
        const std::size_t index = static_cast<std::size_t>(leaf);
        const int cluster = places.tree.cluster_of_leaf[index];
        if (places.tree.is_solid[index] || cluster == last) continue;
        last = cluster;
        std::vector<Presence>& here = presences[static_cast<std::size_t>(cluster)];
        if (here.empty() || here.back().slot != slot) here.push_back({slot, false, {}});
        Presence& presence = here.back();
        if (presence.faces_all) continue;
        presence.facings.push_back(facing);
        if (triangle.facing_sign != 0.0 && presence.facings.size() <= kMostFacings) continue;
        presence.faces_all = true;
        presence.facings.clear();
    }
}

/// The same for a chunk as a whole, wherever its box lies: more is seen, in a fraction of the time.
void add_slot_box(const SlotPlaces& places, std::uint32_t slot, std::vector<std::vector<Presence>>& presences)
{
    const ChunkSlot& place = places.slots[slot];
    const MeshChunk& chunk =
        places.chunks_of_mesh[static_cast<std::size_t>(places.scene.objects[place.object].mesh)][place.chunk];
    std::vector<int> leaves;
    leaves_of_box(places.tree, transformed(chunk.bounds_object, places.scene.world_from_object(place.object)),
                  slack_m(places.tree.grid), leaves);
    for (const int leaf : leaves) {
        const std::size_t index = static_cast<std::size_t>(leaf);
        if (places.tree.is_solid[index]) continue;
        std::vector<Presence>& here = presences[static_cast<std::size_t>(places.tree.cluster_of_leaf[index])];
        if (here.empty() || here.back().slot != slot) here.push_back({slot, true, {}});
    }
}

bool is_animated(const SlotPlaces& places, std::uint32_t slot)
{
    const Object& object = places.scene.objects[places.slots[slot].object];
    return places.scene.nodes[static_cast<std::size_t>(object.node)].is_animated;
}

}  // namespace

LeafRows slots_seen(const SlotPlaces& places, const LeafRows& clusters_seen)
{
    std::vector<std::vector<Presence>> presences(static_cast<std::size_t>(places.tree.cluster_count));
    LeafRows rows(places.tree.cluster_count, static_cast<int>(places.slots.size()));
    const bool are_many = drawn_triangle_count(places.scene) > kMostTriangles;
    for (std::uint32_t slot = 0; slot < places.slots.size(); ++slot) {
        if (!is_animated(places, slot)) {
            if (are_many)
                add_slot_box(places, slot, presences);
            else
                for (const SlotTriangle& triangle : slot_triangles(places, slot))
                    add_triangle(places, triangle, slot, presences);
            continue;
        }
        for (int cluster = 0; cluster < rows.leaf_count(); ++cluster) rows.show(cluster, static_cast<int>(slot));
    }
    const double slack = slack_m(places.tree.grid);
    for (int cluster = 0; cluster < rows.leaf_count(); ++cluster) {
        const Box& box = places.cluster_boxes[static_cast<std::size_t>(cluster)];
        visit_bits(clusters_seen.row(cluster), [&](int seen) {
            for (const Presence& presence : presences[static_cast<std::size_t>(seen)]) {
                const int slot = static_cast<int>(presence.slot);
                if (rows.sees(cluster, slot)) continue;
                const bool is_seen =
                    presence.faces_all ||
                    std::any_of(presence.facings.begin(), presence.facings.end(),
                                [&](const Facing& facing) { return is_partly_in_front(box, facing, slack); });
                if (is_seen) rows.show(cluster, slot);
            }
        });
    }
    return rows;
}

}  // namespace hw
