#include "hatchway/geometry/silhouettes/cluster_search.hpp"

#include <algorithm>
#include <bit>

#include "hatchway/geometry/surface/plane_products.hpp"

namespace hw {
namespace {

constexpr std::uint32_t kFaces = FaceClusters::kFaces;
constexpr std::size_t kAhead = 10;  // clusters whose memory is on its way

/// The numbers of edges are not sent for: few of them will be needed.
void prefetch(const FaceClusters::Cluster& cluster)
{
    const auto* const end = reinterpret_cast<const char*>(cluster.edges);
    for (const auto* at = reinterpret_cast<const char*>(cluster.planes); at < end; at += 64) __builtin_prefetch(at);
}

std::uint32_t own_faces(const FacingFilter& filter, std::uint32_t cluster)
{
    return std::min(kFaces, filter.face_count() - cluster * kFaces);
}

void decide_portably(const FacingFilter& filter, const FaceClusters& clusters, const EyeSteps& eye,
                     std::span<const std::uint32_t> mixed, std::span<ClusterFacing> facing)
{
    for (std::size_t i = 0; i < facing.size(); ++i) {
        const FaceClusters::Cluster cluster = clusters.cluster(mixed[i]);
        facing[i] = {};
        decide_planes(cluster.planes, kFaces + cluster.neighbour_count, eye, {facing[i].front, facing[i].open});
        facing[i].open[0] &= bits_until(own_faces(filter, mixed[i]));
    }
}

/// Kept only when wanted: no branch to mispredict.
inline std::uint32_t append_wanted(std::uint64_t differing, const std::uint32_t* edges, const WantedEdges& wanted,
                                   std::uint32_t* found)
{
    std::uint32_t count = 0;
    for (; differing != 0; differing &= differing - 1) {
        const std::uint32_t edge = edges[std::countr_zero(differing)];
        found[count] = edge;
        count += wanted.has(edge);
    }
    return count;
}

std::uint32_t list_portably(const FaceClusters& clusters, std::span<const std::uint32_t> mixed,
                            std::span<const ClusterFacing> facing, const WantedEdges& wanted, std::uint32_t* found)
{
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < facing.size(); ++i) {
        const FaceClusters::Cluster cluster = clusters.cluster(mixed[i]);
        const auto bit = [&](std::uint32_t place) { return facing[i].front[place / 32] >> place % 32 & 1; };
        for (std::uint32_t edge = 0; edge < cluster.edge_count; ++edge) {
            const std::uint32_t differs = bit(cluster.places[edge]) ^ bit(cluster.places[cluster.edge_count + edge]);
            count += append_wanted(differs, cluster.edges + edge, wanted, found + count);
        }
    }
    return count;
}

#ifdef HW_HAS_AVX2_PATH
__attribute__((target("avx2"))) void decide_with_avx2(const FacingFilter& filter, const FaceClusters& clusters,
                                                      const EyeSteps& eye, std::span<const std::uint32_t> mixed,
                                                      std::span<ClusterFacing> facing)
{
    const EightEyes eyes = eight_eyes(eye.eye);
    const __m256i bound = _mm256_set1_epi32(eye.bound);
    for (std::size_t i = 0; i < facing.size(); ++i) {
        if (i + kAhead < mixed.size()) prefetch(clusters.cluster(mixed[i + kAhead]));
        const FaceClusters::Cluster cluster = clusters.cluster(mixed[i]);
        facing[i] = {};
        const WordSides own = word_sides(cluster.planes, kFaces, eyes, bound);
        facing[i].front[0] = own.front;
        facing[i].open[0] = ~own.certain & bits_until(own_faces(filter, mixed[i]));
        for (std::uint32_t at = 0; at < cluster.neighbour_count; at += 32) {
            const std::uint32_t count = std::min(32u, cluster.neighbour_count - at);
            const WordSides sides = word_sides(cluster.planes + (kFaces + at) / 8, count, eyes, bound);
            facing[i].front[1 + at / 32] = sides.front;
            facing[i].open[1 + at / 32] = ~sides.certain & bits_until(count);
        }
    }
}

/// All bits set in the bytes of those places whose bit is 0.
__attribute__((target("avx2"))) inline __m256i are_back(__m256i front, const FaceClusters::Place* places)
{
    const __m256i bit_of = _mm256_set1_epi64x(static_cast<long long>(0x8040201008040201ull));
    const __m256i place = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(places));
    const __m256i byte = _mm256_and_si256(_mm256_srli_epi16(place, 3), _mm256_set1_epi8(15));
    const __m256i own = _mm256_shuffle_epi8(bit_of, _mm256_and_si256(place, _mm256_set1_epi8(7)));
    return _mm256_cmpeq_epi8(_mm256_and_si256(_mm256_shuffle_epi8(front, byte), own), _mm256_setzero_si256());
}

/// A bit for each of 32 edges whose faces differ.
__attribute__((target("avx2"))) inline std::uint64_t differing(__m256i front, const FaceClusters::Place* a,
                                                               const FaceClusters::Place* b)
{
    const __m256i differ = _mm256_xor_si256(are_back(front, a), are_back(front, b));
    return static_cast<std::uint32_t>(_mm256_movemask_epi8(differ));
}

/// Up to 64 edges from `at` on.
__attribute__((target("avx2"))) inline std::uint64_t differing_edges(const FaceClusters::Cluster& cluster,
                                                                     std::uint32_t at, const ClusterFacing& facing)
{
    if (at >= cluster.edge_count) return 0;
    const auto* words = reinterpret_cast<const __m128i*>(facing.front.data());
    const __m256i front = _mm256_broadcastsi128_si256(_mm_loadu_si128(words));
    const FaceClusters::Place* const a = cluster.places + at;
    const FaceClusters::Place* const b = a + cluster.edge_count;
    const std::uint64_t bits = differing(front, a, b) | differing(front, a + 32, b + 32) << 32;
    const std::uint32_t left = cluster.edge_count - at;
    return left < 64 ? bits & ((std::uint64_t{1} << left) - 1) : bits;
}

/// The numbers of edges are sent for first, since few of them are needed and all are far away.
__attribute__((target("avx2"))) std::uint32_t list_with_avx2(const FaceClusters& clusters,
                                                             std::span<const std::uint32_t> mixed,
                                                             std::span<const ClusterFacing> facing,
                                                             const WantedEdges& wanted, std::uint32_t* found)
{
    std::array<std::array<std::uint64_t, 2>, ClusterFacing::kBatch> bits;
    for (std::size_t i = 0; i < facing.size(); ++i) {
        const FaceClusters::Cluster cluster = clusters.cluster(mixed[i]);
        for (std::uint32_t half = 0; half < 2; ++half) {
            bits[i][half] = differing_edges(cluster, 64 * half, facing[i]);
            for (std::uint32_t at = 0; at < 64; at += 16) {
                if ((bits[i][half] >> at & 0xffff) != 0) __builtin_prefetch(cluster.edges + 64 * half + at);
            }
        }
    }
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < facing.size(); ++i) {
        const std::uint32_t* const edges = clusters.cluster(mixed[i]).edges;
        count += append_wanted(bits[i][0], edges, wanted, found + count);
        count += append_wanted(bits[i][1], edges + 64, wanted, found + count);
    }
    return count;
}
#endif

}  // namespace

void decide_clusters(const FacingFilter& filter, const FaceClusters& clusters, const EyeSteps& eye,
                     std::span<const std::uint32_t> mixed, std::span<ClusterFacing> facing)
{
#ifdef HW_HAS_AVX2_PATH
    if (has_avx2()) return decide_with_avx2(filter, clusters, eye, mixed, facing);
#endif
    decide_portably(filter, clusters, eye, mixed, facing);
}

std::uint32_t list_differing(const FaceClusters& clusters, std::span<const std::uint32_t> mixed,
                             std::span<const ClusterFacing> facing, const WantedEdges& wanted, std::uint32_t* found)
{
#ifdef HW_HAS_AVX2_PATH
    if (has_avx2()) return list_with_avx2(clusters, mixed, facing, wanted, found);
#endif
    return list_portably(clusters, mixed, facing, wanted, found);
}

}  // namespace hw
