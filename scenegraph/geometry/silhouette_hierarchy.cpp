// Only clusters that the cones leave open have their faces looked at, and only where those then differ are edges looked
// at: edges cost more than faces, which are decided eight at a time. Edges between a cluster that looks at the viewer
// as a whole and one that looks away need the bytes of their faces too; those are then filled in from the cluster.
#include <algorithm>
#include <array>
#include <cstring>

#include "core/error.hpp"
#include "geometry/silhouette_stages.hpp"
#include "geometry/surface_faces.hpp"

namespace hw {
namespace {

using Facing = FaceClusters::Facing;

constexpr std::uint32_t kBlocks = FaceClusters::kFaces / FacingFilter::kBlock;

class ClusterSearch {
 public:
    ClusterSearch(const SilhouetteSearch& search, SilhouetteScratch& scratch)
        : search_(search),
          surface_(search.surface),
          clusters_(search.surface.clusters),
          scratch_(scratch),
          first_(search.ranges[0]),
          second_(search.ranges.size() > 1 ? search.ranges[1] : EdgeRange{})
    {
        HW_ASSERT(search.ranges.size() <= 2);
        const FacingFilter& filter = surface_.filter;
        make_room(scratch.facing, std::size_t{clusters_.count()} * FaceClusters::kFaces);
        make_room(scratch.open_faces, std::size_t{filter.block_count()} * FacingFilter::kBlock);
        make_room(scratch.groups, clusters_.group_count());
        make_room(scratch.clusters, clusters_.count());
        make_room(scratch.filled, clusters_.count());
        std::fill_n(scratch.filled.begin(), clusters_.count(), std::uint8_t{0});
    }

    std::uint32_t run()
    {
        clusters_.decide(search_.viewpoint, scratch_.groups, scratch_.clusters);
        open_mixed_clusters();
        for (std::uint32_t group = 0; group < clusters_.group_count(); ++group) {
            if (is_far_from_contour(group)) continue;
            const std::uint32_t begin = group * FaceClusters::kGroup;
            const std::uint32_t end = std::min(clusters_.count(), begin + FaceClusters::kGroup);
            for (std::uint32_t cluster = begin; cluster < end; ++cluster) test_links(cluster);
        }
        test_loose_edges();
        return count_;
    }

 private:
    bool is_far_from_contour(std::uint32_t group) const
    {
        const Facing own = scratch_.groups[group];
        const auto others = clusters_.group_links(group);
        return own != Facing::mixed && std::all_of(others.begin(), others.end(),
                                                   [&](std::uint32_t other) { return scratch_.groups[other] == own; });
    }

    void test_links(std::uint32_t cluster)
    {
        for (const FaceClusters::Link& link : clusters_.links(cluster)) {
            const Facing own = scratch_.clusters[cluster], other = scratch_.clusters[link.other];
            if (own == other && own != Facing::mixed) continue;
            fill(cluster);
            fill(link.other);
            test(cluster, link);
        }
    }

    void open_mixed_clusters()
    {
        const FacingFilter::Query query = surface_.filter.query(search_.viewpoint);
        for (std::uint32_t first = 0; first < clusters_.count();) {
            if (first % FaceClusters::kGroup == 0 && scratch_.groups[first / FaceClusters::kGroup] != Facing::mixed) {
                first += FaceClusters::kGroup;
                continue;
            }
            if (scratch_.clusters[first] != Facing::mixed) {
                ++first;
                continue;
            }
            std::uint32_t end = first + 1;
            while (end < clusters_.count() && scratch_.clusters[end] == Facing::mixed) ++end;
            const std::uint32_t end_block = std::min(end * kBlocks, surface_.filter.block_count());
            decide_blocks(surface_, search_.viewpoint, query, first * kBlocks, end_block - first * kBlocks, scratch_);
            std::fill(scratch_.filled.begin() + first, scratch_.filled.begin() + end, std::uint8_t{1});
            scratch_.counters.faces_tested += std::uint64_t{end - first} * FaceClusters::kFaces;
            first = end;
        }
        // A cluster with a collinear face is never uniform, so that its bytes are there.
        for (const auto& entry : surface_.filter.inherited) {
            scratch_.facing[entry.face] = entry.source != kNoFace && is_front(entry.source);
        }
        for (std::uint32_t cluster = 0; cluster < clusters_.count(); ++cluster) {
            if (scratch_.clusters[cluster] == Facing::mixed) scratch_.clusters[cluster] = looked_at(cluster);
        }
    }

    /// What the faces of an opened cluster turned out to be. The last cluster may hold padding and stays mixed.
    Facing looked_at(std::uint32_t cluster) const
    {
        if (cluster + 1 == clusters_.count()) return Facing::mixed;
        constexpr std::uint64_t kAllFront = 0x0101010101010101;
        std::array<std::uint64_t, FaceClusters::kFaces / 8> bytes;
        std::memcpy(bytes.data(), scratch_.facing.data() + std::size_t{cluster} * FaceClusters::kFaces, sizeof(bytes));
        const bool is_uniform = std::all_of(bytes.begin(), bytes.end(), [&](auto eight) { return eight == bytes[0]; });
        if (!is_uniform || (bytes[0] != 0 && bytes[0] != kAllFront)) return Facing::mixed;
        return bytes[0] == 0 ? Facing::back : Facing::front;
    }

    bool is_front(std::uint32_t face) const
    {
        const Facing cluster = scratch_.clusters[face / FaceClusters::kFaces];
        return cluster == Facing::mixed ? scratch_.facing[face] != 0 : cluster == Facing::front;
    }

    void fill(std::uint32_t cluster)
    {
        if (scratch_.filled[cluster]) return;
        scratch_.filled[cluster] = 1;
        std::memset(scratch_.facing.data() + std::size_t{cluster} * FaceClusters::kFaces,
                    scratch_.clusters[cluster] == Facing::front ? 1 : 0, FaceClusters::kFaces);
    }

    std::uint32_t is_wanted(std::uint32_t edge) const
    {
        return static_cast<std::uint32_t>(edge - first_.begin < first_.size()) |
               static_cast<std::uint32_t>(edge - second_.begin < second_.size());
    }

    void keep(std::uint32_t edge)
    {
        if (is_wanted(edge) != 0) scratch_.edges[count_++] = edge;
    }

    void test(std::uint32_t cluster, const FaceClusters::Link& link)
    {
        const std::uint8_t* const own = scratch_.facing.data() + std::size_t{cluster} * FaceClusters::kFaces;
        const std::uint8_t* const other = scratch_.facing.data() + std::size_t{link.other} * FaceClusters::kFaces;
        const std::array<std::uint8_t, 2>* const faces = clusters_.edge_faces().data();
        const std::uint32_t* const edges = clusters_.edges().data();
        std::uint32_t* const found = scratch_.edges.data();
        std::uint32_t count = count_;
        for (std::uint32_t i = link.begin; i < link.end; ++i) {
            const std::uint32_t edge = edges[i];
            found[count] = edge;  // kept only when it differs and is wanted: no branch to mispredict
            count += static_cast<std::uint32_t>(own[faces[i][0]] ^ other[faces[i][1]]) & is_wanted(edge);
        }
        count_ = count;
        scratch_.counters.edges_tested += link.end - link.begin;
    }

    void test_loose_edges()
    {
        const auto face_count = static_cast<std::uint32_t>(surface_.faces.size());
        for (const std::uint32_t edge : clusters_.loose_edges()) {
            const auto [a, b] = surface_.edges.faces[edge];
            const bool is_b_front = search_.has_turned_faces
                                        ? is_twin_facing(surface_, b - face_count, search_.viewpoint, scratch_.counters)
                                        : is_front(surface_.filter.twins[b - face_count].face);
            if (is_front(a) != is_b_front) keep(edge);
        }
        scratch_.counters.edges_tested += clusters_.loose_edges().size();
    }

    const SilhouetteSearch& search_;
    const Surface& surface_;
    const FaceClusters& clusters_;
    SilhouetteScratch& scratch_;
    EdgeRange first_;
    EdgeRange second_;
    std::uint32_t count_ = 0;
};

}  // namespace

std::uint32_t search_clusters(const SilhouetteSearch& search, SilhouetteScratch& scratch)
{
    return ClusterSearch(search, scratch).run();
}

}  // namespace hw
