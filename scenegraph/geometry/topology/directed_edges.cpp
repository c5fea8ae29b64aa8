#include "hatchway/geometry/topology/directed_edges.hpp"

#include <algorithm>

namespace hw {
namespace {

/// Counting sort by the smaller position, then a short sort in each bucket: linear on meshes.
std::vector<DirectedEdge> bucketed_by_low(std::span<const FaceCorners> faces, std::vector<std::uint32_t>& bucket_begin)
{
    std::uint32_t highest = 0;
    for (const FaceCorners& face : faces) highest = std::max({highest, face[0], face[1], face[2]});
    bucket_begin.assign(std::size_t{highest} + 2, 0);
    for (const FaceCorners& face : faces) {
        for (int corner = 0; corner < 3; ++corner) ++bucket_begin[std::min(face[corner], face[(corner + 1) % 3]) + 1];
    }
    for (std::size_t i = 1; i < bucket_begin.size(); ++i) bucket_begin[i] += bucket_begin[i - 1];

    std::vector<DirectedEdge> uses(3 * faces.size());
    std::vector<std::uint32_t> next(bucket_begin.begin(), bucket_begin.end() - 1);
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        for (std::uint8_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t from = faces[f][corner], to = faces[f][(corner + 1) % 3];
            uses[next[std::min(from, to)]++] = {std::min(from, to), std::max(from, to), f, corner, from < to};
        }
    }
    return uses;
}

/// They stand by rising face already, and there are few of them but at the hub of a fan.
void sort_by_high(std::span<DirectedEdge> uses)
{
    constexpr std::size_t kFew = 32;
    if (uses.size() > kFew) {
        std::stable_sort(uses.begin(), uses.end(), [](const auto& a, const auto& b) { return a.high < b.high; });
        return;
    }
    for (std::size_t i = 1; i < uses.size(); ++i) {
        const DirectedEdge use = uses[i];
        std::size_t at = i;
        for (; at > 0 && uses[at - 1].high > use.high; --at) uses[at] = uses[at - 1];
        uses[at] = use;
    }
}

}  // namespace

std::vector<DirectedEdge> sorted_directed_edges(std::span<const FaceCorners> faces)
{
    std::vector<std::uint32_t> bucket_begin;
    std::vector<DirectedEdge> uses = bucketed_by_low(faces, bucket_begin);
    for (std::size_t bucket = 0; bucket + 1 < bucket_begin.size(); ++bucket) {
        sort_by_high(std::span(uses).subspan(bucket_begin[bucket], bucket_begin[bucket + 1] - bucket_begin[bucket]));
    }
    return uses;
}

std::vector<FaceCorners> face_neighbours(std::size_t face_count, std::span<const DirectedEdge> uses)
{
    std::vector<FaceCorners> neighbours(face_count, FaceCorners{kNoFace, kNoFace, kNoFace});
    for_each_edge(uses, [&](std::span<const DirectedEdge> edge) {
        if (edge.size() != 2) return;
        neighbours[edge[0].face][edge[0].corner] = edge[1].face;
        neighbours[edge[1].face][edge[1].corner] = edge[0].face;
    });
    return neighbours;
}

}  // namespace hw
