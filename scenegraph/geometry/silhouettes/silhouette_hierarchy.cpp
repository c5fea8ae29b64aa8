// Only clusters whose box of planes the eye is not certain of are looked into: their planes give a bit for each face,
// of the cluster and of its neighbours, and edges compare two of these bits, 32 edges at a time.
#include "hatchway/geometry/silhouettes/silhouette_hierarchy.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "hatchway/core/error.hpp"
#include "hatchway/geometry/silhouettes/cluster_search.hpp"
#include "hatchway/geometry/surface/surface_faces.hpp"

namespace hw {
namespace {

constexpr std::size_t kBatch = ClusterFacing::kBatch;

class ClusterSearch {
 public:
    ClusterSearch(const SilhouetteSearch& search, SilhouetteScratch& scratch)
        : search_(search),
          surface_(search.surface),
          clusters_(search.surface.clusters),
          scratch_(scratch),
          eye_(search.surface.filter.eye_steps(search.viewpoint))
    {
        HW_ASSERT(search.ranges.size() == 1 || search.ranges.size() == 2);
        wanted_ = {search.ranges.front(), search.ranges.size() > 1 ? search.ranges[1] : EdgeRange{}};
        make_room(scratch.front, (clusters_.group_count() + 31) / 32);
        make_room(scratch.open, (clusters_.group_count() + 31) / 32);
        make_room(scratch.mixed, clusters_.count());
    }

    std::uint32_t run()
    {
        const std::uint32_t count = clusters_.find_mixed(eye_, {scratch_.front, scratch_.open}, scratch_.mixed);
        const std::span<const std::uint32_t> mixed(scratch_.mixed.data(), count);
        std::array<ClusterFacing, kBatch> facing;
        for (std::size_t begin = 0; begin < count; begin += kBatch) {
            const std::size_t size = std::min(kBatch, count - begin);
            decide_clusters(surface_.filter, clusters_, eye_, mixed.subspan(begin), std::span(facing).first(size));
            for (std::size_t i = 0; i < size; ++i) decide_open(mixed[begin + i], facing[i]);
            found_ += list_differing(clusters_, mixed.subspan(begin), std::span(facing).first(size), wanted_,
                                     scratch_.edges.data() + found_);
        }
        for (const std::uint32_t edge : clusters_.loose_edges()) test_loose(edge);
        return found_;
    }

 private:
    void decide_open(std::uint32_t number, ClusterFacing& facing)
    {
        const FaceClusters::Cluster cluster = clusters_.cluster(number);
        scratch_.counters.faces_tested += FaceClusters::kFaces + cluster.neighbour_count;
        scratch_.counters.edges_tested += cluster.edge_count;
        for (std::uint32_t word = 0; word < ClusterFacing::kWords; ++word) {
            for (std::uint32_t open = facing.open[word]; open != 0; open &= open - 1) {
                const auto bit = static_cast<std::uint32_t>(std::countr_zero(open));
                const std::uint32_t face =
                    word == 0 ? number * FaceClusters::kFaces + bit : neighbour(number, cluster, 32 * word + bit);
                const bool is_front = is_open_face_front(surface_, face, search_.viewpoint, scratch_.counters);
                facing.front[word] |= static_cast<std::uint32_t>(is_front) << bit;
            }
        }
    }

    /// The face at a neighbour's place. Rarely asked for, so it is not stored but found by an edge.
    std::uint32_t neighbour(std::uint32_t number, const FaceClusters::Cluster& cluster, std::uint32_t place) const
    {
        const FaceClusters::Place* const b = cluster.places + cluster.edge_count;
        const auto at = std::find(b, b + cluster.edge_count, place) - b;
        const auto [face_a, face_b] = surface_.edges[cluster.edges[at]].faces();
        return face_a / FaceClusters::kFaces == number ? face_b : face_a;
    }

    void test_loose(std::uint32_t edge)
    {
        const auto face_count = static_cast<std::uint32_t>(surface_.faces.size());
        const auto [a, b] = surface_.edges[edge].faces();
        const auto is_front = [&](std::uint32_t face) {
            return is_open_face_front(surface_, face, search_.viewpoint, scratch_.counters);
        };
        const bool is_b_front = search_.has_turned_faces
                                    ? is_twin_facing(surface_, b - face_count, search_.viewpoint, scratch_.counters)
                                    : is_front(surface_.filter.twins[b - face_count].face);
        scratch_.edges[found_] = edge;
        found_ += is_front(a) != is_b_front && wanted_.has(edge);
        ++scratch_.counters.edges_tested;
    }

    const SilhouetteSearch& search_;
    const Surface& surface_;
    const FaceClusters& clusters_;
    SilhouetteScratch& scratch_;
    EyeSteps eye_;
    WantedEdges wanted_;
    std::uint32_t found_ = 0;
};

}  // namespace

std::uint32_t search_clusters(const SilhouetteSearch& search, SilhouetteScratch& scratch)
{
    return ClusterSearch(search, scratch).run();
}

}  // namespace hw
