#include "hatchway/geometry/lines/line_chains.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

namespace hw {
namespace {

constexpr std::uint32_t kNoEnd = 0xffffffffu;

// End number 2 i is where piece i begins, 2 i + 1 where it ends.

struct EndAt {
    std::uint32_t vertex;
    std::uint32_t end;
};

glm::dvec2 point_of(std::span<const LinePiece> pieces, std::uint32_t end)
{
    return end & 1 ? pieces[end / 2].to : pieces[end / 2].from;
}

double depth_of(std::span<const LinePiece> pieces, std::uint32_t end)
{
    return end & 1 ? pieces[end / 2].to_depth : pieces[end / 2].from_depth;
}

/// Unit direction in which a piece leaves its end.
glm::dvec2 leaving(std::span<const LinePiece> pieces, std::uint32_t end)
{
    const glm::dvec2 direction = point_of(pieces, end ^ 1) - point_of(pieces, end);
    const double length = glm::length(direction);
    return length > 0.0 ? direction / length : glm::dvec2(0.0);
}

/// Pairs the ends at one vertex, straightest first.
void pair_up(std::span<const LinePiece> pieces, std::span<const EndAt> ends, std::vector<std::uint32_t>& partner)
{
    struct Candidate {
        double cosine;
        std::uint32_t a, b;
    };
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        for (std::size_t j = i + 1; j < ends.size(); ++j) {
            const double cosine = glm::dot(leaving(pieces, ends[i].end), leaving(pieces, ends[j].end));
            candidates.push_back({cosine, ends[i].end, ends[j].end});
        }
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.cosine < b.cosine; });
    for (const Candidate& pair : candidates) {
        if (partner[pair.a] != kNoEnd || partner[pair.b] != kNoEnd) continue;
        partner[pair.a] = pair.b;
        partner[pair.b] = pair.a;
    }
}

std::vector<std::uint32_t> partners(std::span<const LinePiece> pieces)
{
    std::vector<EndAt> ends;
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
        if (pieces[i].from_vertex != kFreeEnd) ends.push_back({pieces[i].from_vertex, 2 * i});
        if (pieces[i].to_vertex != kFreeEnd) ends.push_back({pieces[i].to_vertex, 2 * i + 1});
    }
    std::sort(ends.begin(), ends.end(), [](const EndAt& a, const EndAt& b) {
        return a.vertex != b.vertex ? a.vertex < b.vertex : a.end < b.end;
    });
    std::vector<std::uint32_t> partner(2 * pieces.size(), kNoEnd);
    for (std::size_t begin = 0; begin < ends.size();) {
        std::size_t end = begin + 1;
        while (end < ends.size() && ends[end].vertex == ends[begin].vertex) ++end;
        pair_up(pieces, std::span(ends).subspan(begin, end - begin), partner);
        begin = end;
    }
    return partner;
}

}  // namespace

std::vector<LineChain> join_pieces(std::span<const LinePiece> pieces)
{
    const std::vector<std::uint32_t> partner = partners(pieces);
    std::vector<bool> is_used(pieces.size(), false);
    std::vector<LineChain> chains;
    for (std::uint32_t piece = 0; piece < pieces.size(); ++piece) {
        if (is_used[piece]) continue;
        std::uint32_t start = 2 * piece;  // walk back to where the chain begins, or once around
        while (partner[start] != kNoEnd && partner[start] / 2 != piece) start = partner[start] ^ 1;
        const bool is_closed = partner[start] != kNoEnd;
        if (is_closed) start = 2 * piece;

        LineChain chain{{point_of(pieces, start)}, {depth_of(pieces, start)}, {}, is_closed};
        for (std::uint32_t end = start; end != kNoEnd && !is_used[end / 2]; end = partner[end ^ 1]) {
            is_used[end / 2] = true;
            chain.points.push_back(point_of(pieces, end ^ 1));
            chain.depths.push_back(depth_of(pieces, end ^ 1));
            chain.sources.push_back(pieces[end / 2].source);
        }
        if (is_closed) {
            chain.points.pop_back();
            chain.depths.pop_back();
        }
        chains.push_back(std::move(chain));
    }
    return chains;
}

}  // namespace hw
