#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hw {

using FaceCorners = std::array<std::uint32_t, 3>;

/// No face: beyond a border, or without a triangle.
inline constexpr std::uint32_t kNoFace = 0xffffffffu;

/// One face's use of an edge: its side from corner `corner` to the next.
struct DirectedEdge {
    std::uint32_t low;   ///< The smaller position id.
    std::uint32_t high;  ///< The larger.
    std::uint32_t face;
    std::uint8_t corner;
    bool is_forward;  ///< The face goes from `low` to `high`.
};

/// All sides of all faces, sorted by edge, then by face.
std::vector<DirectedEdge> sorted_directed_edges(std::span<const FaceCorners> faces);

/// Calls `visit(std::span<const DirectedEdge>)` for each edge with all its uses, in order.
template <typename Visit>
void for_each_edge(std::span<const DirectedEdge> uses, Visit&& visit)
{
    for (std::size_t begin = 0; begin < uses.size();) {
        std::size_t end = begin + 1;
        while (end < uses.size() && uses[end].low == uses[begin].low && uses[end].high == uses[begin].high) ++end;
        visit(uses.subspan(begin, end - begin));
        begin = end;
    }
}

/// For each side of each face the face beyond it, over edges of exactly two faces; kNoFace elsewhere.
std::vector<FaceCorners> face_neighbours(std::size_t face_count, std::span<const DirectedEdge> uses);

}  // namespace hw
