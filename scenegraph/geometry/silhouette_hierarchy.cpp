// Only clusters that the cones leave open have their faces looked at. Facing then is a mask of 32 bits for each
// cluster, and edges are looked at only where two linked clusters, or the faces of one, are not all alike: eight at a
// time, shifting the two masks by the places of their faces.
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "core/error.hpp"
#include "geometry/silhouette_stages.hpp"
#include "geometry/surface_faces.hpp"

#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>
#define HW_HAS_AVX2_PATH 1
#endif

namespace hw {
namespace {

using Facing = FaceClusters::Facing;
using FacePair = std::array<std::uint8_t, 2>;

constexpr std::uint32_t kBlocks = FaceClusters::kFaces / FacingFilter::kBlock;
static_assert(FaceClusters::kFaces == 32, "a mask has a bit for each face");

/// Edges of a link: for each the places of its two faces in their clusters.
struct LinkEdges {
    const FacePair* faces;
    const std::uint32_t* edges;
    std::uint32_t count;
};

/// The edges that are asked for.
struct Wanted {
    EdgeRange first, second;

    std::uint32_t has(std::uint32_t edge) const
    {
        return static_cast<std::uint32_t>(edge - first.begin < first.size()) |
               static_cast<std::uint32_t>(edge - second.begin < second.size());
    }
};

std::uint32_t test_portably(const LinkEdges& link, std::uint32_t own, std::uint32_t other, const Wanted& wanted,
                            std::uint32_t* found)
{
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < link.count; ++i) {
        found[count] = link.edges[i];  // kept only when it differs and is wanted: no branch to mispredict
        count += (own >> link.faces[i][0] ^ other >> link.faces[i][1]) & wanted.has(link.edges[i]);
    }
    return count;
}

#ifdef HW_HAS_AVX2_PATH
__attribute__((target("avx2"))) std::uint32_t test_with_avx2(const LinkEdges& link, std::uint32_t own,
                                                             std::uint32_t other, const Wanted& wanted,
                                                             std::uint32_t* found)
{
    const __m256i own_bits = _mm256_set1_epi32(static_cast<int>(own));
    const __m256i other_bits = _mm256_set1_epi32(static_cast<int>(other));
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < link.count; i += 8) {
        const __m128i pairs = _mm_loadu_si128(reinterpret_cast<const __m128i*>(link.faces + i));
        const __m256i own_places = _mm256_cvtepu16_epi32(_mm_and_si128(pairs, _mm_set1_epi16(0xff)));
        const __m256i other_places = _mm256_cvtepu16_epi32(_mm_srli_epi16(pairs, 8));
        const __m256i differ =
            _mm256_xor_si256(_mm256_srlv_epi32(own_bits, own_places), _mm256_srlv_epi32(other_bits, other_places));
        auto bits = static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(_mm256_slli_epi32(differ, 31))));
        if (link.count - i < 8) bits &= (1u << (link.count - i)) - 1;
        for (; bits != 0; bits &= bits - 1) {
            const std::uint32_t edge = link.edges[i + static_cast<std::uint32_t>(std::countr_zero(bits))];
            found[count] = edge;
            count += wanted.has(edge);
        }
    }
    return count;
}
#endif

/// A bit for each of 32 bytes of 0 or 1.
std::uint32_t mask_of(const std::uint8_t* facing)
{
    std::array<std::uint64_t, 4> eights;
    std::memcpy(eights.data(), facing, sizeof(eights));
    std::uint32_t mask = 0;
    for (int i = 0; i < 4; ++i) mask |= static_cast<std::uint32_t>(eights[i] * 0x0102040810204080 >> 56) << (8 * i);
    return mask;
}

class ClusterSearch {
 public:
    ClusterSearch(const SilhouetteSearch& search, SilhouetteScratch& scratch)
        : search_(search),
          surface_(search.surface),
          clusters_(search.surface.clusters),
          scratch_(scratch),
          wanted_{search.ranges[0], search.ranges.size() > 1 ? search.ranges[1] : EdgeRange{}}
    {
        HW_ASSERT(search.ranges.size() <= 2);
        make_room(scratch.facing, std::size_t{clusters_.count()} * FaceClusters::kFaces);
        make_room(scratch.open_faces, std::size_t{surface_.filter.block_count()} * FacingFilter::kBlock);
        make_room(scratch.groups, clusters_.group_count());
        make_room(scratch.masks, clusters_.count());
        make_room(scratch.mixed, clusters_.count() + 1);  // one is written past the last
    }

    std::uint32_t run()
    {
        look_at_clusters(clusters_.decide(search_.viewpoint, scratch_.groups, scratch_.masks, scratch_.mixed));
        for (std::uint32_t group = 0; group < clusters_.group_count(); ++group) {
            if (!is_far_from_contour(group)) test_links(group);
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

    /// Fills in the masks of the clusters that no cone decided, runs of neighbours together.
    void look_at_clusters(std::uint32_t mixed_count)
    {
        const FacingFilter::Query query = surface_.filter.query(search_.viewpoint);
        for (std::uint32_t i = 0; i < mixed_count;) {
            const std::uint32_t first = scratch_.mixed[i], begin = i;
            while (i < mixed_count && scratch_.mixed[i] == first + (i - begin)) ++i;
            const std::uint32_t end = first + (i - begin);
            const std::uint32_t end_block = std::min(end * kBlocks, surface_.filter.block_count());
            decide_blocks(surface_, search_.viewpoint, query, first * kBlocks, end_block - first * kBlocks, scratch_);
            for (std::uint32_t cluster = first; cluster < end; ++cluster) {
                scratch_.masks[cluster] = mask_of(scratch_.facing.data() + std::size_t{cluster} * FaceClusters::kFaces);
            }
            scratch_.counters.faces_tested += std::uint64_t{end - first} * FaceClusters::kFaces;
        }
        // A cluster with a collinear face is never decided by its cone.
        for (const auto& entry : surface_.filter.inherited) {
            const std::uint32_t bit = 1u << (entry.face % FaceClusters::kFaces);
            std::uint32_t& mask = scratch_.masks[entry.face / FaceClusters::kFaces];
            mask = entry.source != kNoFace && is_front(entry.source) ? mask | bit : mask & ~bit;
        }
    }

    bool is_front(std::uint32_t face) const
    {
        return (scratch_.masks[face / FaceClusters::kFaces] >> (face % FaceClusters::kFaces) & 1) != 0;
    }

    void test_links(std::uint32_t group)
    {
        const auto [begin, end] = clusters_.group_link_range(group);
        const FaceClusters::Link* const links = clusters_.links().data();
        const std::uint32_t* const masks = scratch_.masks.data();
        for (std::uint32_t i = begin; i < end; ++i) {
            const std::uint32_t own = masks[links[i].clusters[0]], other = masks[links[i].clusters[1]];
            if (own == other && own + 1 <= 1) continue;  // all bits alike in both
            const std::uint32_t first = links[i].begin, size = links[i + 1].begin - first;
            const LinkEdges edges{clusters_.edge_faces().data() + first, clusters_.edges().data() + first, size};
            count_ += test(edges, own, other, scratch_.edges.data() + count_);
            scratch_.counters.edges_tested += size;
        }
    }

    std::uint32_t test(const LinkEdges& link, std::uint32_t own, std::uint32_t other, std::uint32_t* found) const
    {
#ifdef HW_HAS_AVX2_PATH
        static const bool has_avx2 = __builtin_cpu_supports("avx2");
        if (has_avx2) return test_with_avx2(link, own, other, wanted_, found);
#endif
        return test_portably(link, own, other, wanted_, found);
    }

    void test_loose_edges()
    {
        const auto face_count = static_cast<std::uint32_t>(surface_.faces.size());
        for (const std::uint32_t edge : clusters_.loose_edges()) {
            const auto [a, b] = surface_.edges.faces[edge];
            const bool is_b_front = search_.has_turned_faces
                                        ? is_twin_facing(surface_, b - face_count, search_.viewpoint, scratch_.counters)
                                        : is_front(surface_.filter.twins[b - face_count].face);
            if (is_front(a) != is_b_front && wanted_.has(edge) != 0) scratch_.edges[count_++] = edge;
        }
        scratch_.counters.edges_tested += clusters_.loose_edges().size();
    }

    const SilhouetteSearch& search_;
    const Surface& surface_;
    const FaceClusters& clusters_;
    SilhouetteScratch& scratch_;
    Wanted wanted_;
    std::uint32_t count_ = 0;
};

}  // namespace

std::uint32_t search_clusters(const SilhouetteSearch& search, SilhouetteScratch& scratch)
{
    return ClusterSearch(search, scratch).run();
}

}  // namespace hw
