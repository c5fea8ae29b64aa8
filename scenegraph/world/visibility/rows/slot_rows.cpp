#include "hatchway/world/visibility/rows/slot_rows.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "hatchway/world/visibility/rows/slot_triangles.hpp"

namespace hw {
namespace {

/// More triangles than this in one cluster are taken to face every way.
constexpr std::size_t kMostOfPresence = 256;

/// Where a scene draws more triangles than this, chunks are placed by their boxes.
constexpr std::uint64_t kMostTriangles = 12'000'000;

constexpr std::uint64_t kMostPlaced = 8'000'000;   // leaves that triangles touch; the chunks after them by their boxes
constexpr std::uint64_t kMostByBox = 8'000'000;    // leaves that boxes touch; the chunks after them are seen by all
constexpr std::int64_t kMostFacings = 4'000'000;   // kept of all triangles; what comes after faces all
constexpr std::uint64_t kMostTests = 300'000'000;  // of facings; the clusters after them see all

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

/// The slots of each cluster, by their triangles as long as there is room for that.
class SlotPresences {
 public:
    explicit SlotPresences(const SlotPlaces& places)
        : places_(places),
          of_cluster_(static_cast<std::size_t>(places.tree.cluster_count)),
          placed_left_(drawn_triangle_count(places.scene) > kMostTriangles ? 0 : kMostPlaced)
    {
    }

    /// False: there is no room for it, and it is to be seen by all.
    bool add(std::uint32_t slot)
    {
        if (placed_left_ > 0) {
            for (const SlotTriangle& triangle : slot_triangles(places_, slot)) add_triangle(triangle, slot);
            return true;
        }
        if (boxes_left_ > 0) add_box(slot);
        return boxes_left_ > 0;
    }
    const std::vector<Presence>& of_cluster(int cluster) const
    {
        return of_cluster_[static_cast<std::size_t>(cluster)];
    }

 private:
    void add_triangle(const SlotTriangle& triangle, std::uint32_t slot)
    {
        const std::array<glm::dvec3, 3>& corners = triangle.corners_world;
        const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double length = glm::length(normal);
        if (!(length > 0.0)) return;  // never drawn
        Facing facing;
        facing.normal = normal * (triangle.facing_sign / length);
        facing.offset = -glm::dot(facing.normal, corners[0]);
        leaves_.clear();
        leaves_of_polygon(places_.tree, corners, facing.normal, slack_m(places_.tree.grid), leaves_);
        placed_left_ -= std::min<std::uint64_t>(placed_left_, leaves_.size());
        int last = -1;
        for (const int leaf : leaves_) {
            const std::size_t index = static_cast<std::size_t>(leaf);
            const int cluster = places_.tree.cluster_of_leaf[index];
            if (places_.tree.is_solid[index] || cluster == last) continue;
            last = cluster;
            Presence& presence = presence_in(cluster, slot);
            if (presence.faces_all) continue;
            presence.facings.push_back(facing);
            --facings_left_;
            const bool has_room = presence.facings.size() <= kMostOfPresence && facings_left_ > 0;
            if (triangle.facing_sign == 0.0 || !has_room) make_face_all(presence);
        }
    }

    /// The same for a chunk as a whole, wherever its box lies: more is seen, in a fraction of the time.
    void add_box(std::uint32_t slot)
    {
        const ChunkSlot& place = places_.slots[slot];
        const MeshChunk& chunk =
            places_.chunks_of_mesh[static_cast<std::size_t>(places_.scene.objects[place.object].mesh)][place.chunk];
        leaves_.clear();
        leaves_of_box(places_.tree, transformed(chunk.bounds_object, places_.scene.world_from_object(place.object)),
                      slack_m(places_.tree.grid), leaves_);
        boxes_left_ -= std::min<std::uint64_t>(boxes_left_, leaves_.size());
        for (const int leaf : leaves_) {
            const std::size_t index = static_cast<std::size_t>(leaf);
            if (!places_.tree.is_solid[index]) make_face_all(presence_in(places_.tree.cluster_of_leaf[index], slot));
        }
    }

    Presence& presence_in(int cluster, std::uint32_t slot)
    {
        std::vector<Presence>& here = of_cluster_[static_cast<std::size_t>(cluster)];
        if (here.empty() || here.back().slot != slot) here.push_back({slot, false, {}});
        return here.back();
    }
    void make_face_all(Presence& presence)
    {
        presence.faces_all = true;
        facings_left_ += static_cast<std::int64_t>(presence.facings.size());
        presence.facings = {};
    }

    const SlotPlaces& places_;
    std::vector<std::vector<Presence>> of_cluster_;
    std::vector<int> leaves_;  ///< Of one triangle.
    std::uint64_t placed_left_;
    std::uint64_t boxes_left_ = kMostByBox;
    std::int64_t facings_left_ = kMostFacings;
};

/// What one cluster sees of another. False: the tests ran out.
bool show_slots(const std::vector<Presence>& presences, const Box& eyes, int cluster, double slack,
                std::uint64_t& tests_left, LeafRows& rows)
{
    for (const Presence& presence : presences) {
        const int slot = static_cast<int>(presence.slot);
        if (tests_left == 0) return false;
        --tests_left;
        if (rows.sees(cluster, slot)) continue;
        tests_left -= std::min<std::uint64_t>(tests_left, presence.facings.size());
        const bool is_seen = presence.faces_all ||
                             std::any_of(presence.facings.begin(), presence.facings.end(),
                                         [&](const Facing& facing) { return is_partly_in_front(eyes, facing, slack); });
        if (is_seen) rows.show(cluster, slot);
    }
    return true;
}

bool is_animated(const SlotPlaces& places, std::uint32_t slot)
{
    const Object& object = places.scene.objects[places.slots[slot].object];
    return places.scene.nodes[static_cast<std::size_t>(object.node)].is_animated;
}

}  // namespace

LeafRows slots_seen(const SlotPlaces& places, const LeafRows& clusters_seen)
{
    SlotPresences presences(places);
    LeafRows rows(places.tree.cluster_count, static_cast<int>(places.slots.size()));
    for (std::uint32_t slot = 0; slot < places.slots.size(); ++slot) {
        if (!is_animated(places, slot) && presences.add(slot)) continue;
        for (int cluster = 0; cluster < rows.leaf_count(); ++cluster) rows.show(cluster, static_cast<int>(slot));
    }
    const double slack = slack_m(places.tree.grid);
    std::uint64_t tests_left = kMostTests;
    for (int cluster = 0; cluster < rows.leaf_count(); ++cluster) {
        const Box& eyes = places.cluster_boxes[static_cast<std::size_t>(cluster)];
        bool is_done = true;
        visit_bits(clusters_seen.row(cluster), [&](int seen) {
            is_done = is_done && show_slots(presences.of_cluster(seen), eyes, cluster, slack, tests_left, rows);
        });
        for (int slot = 0; slot < rows.column_count() && !is_done; ++slot) rows.show(cluster, slot);
    }
    return rows;
}

}  // namespace hw
