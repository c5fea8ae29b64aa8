#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "hatchway/geometry/lines/line_source.hpp"

namespace hw {

/// A straight piece with ends that may meet other pieces.
struct LinePiece {
    glm::dvec2 from{0.0};
    glm::dvec2 to{0.0};
    std::uint32_t from_vertex = 0;  ///< Pieces meet where these are equal; kFreeEnd meets nothing.
    std::uint32_t to_vertex = 0;
    double from_depth = 0.0;  ///< Passed on to the chain's points.
    double to_depth = 0.0;
    LineSource source;  ///< Passed on to the chain's segments.
};

inline constexpr std::uint32_t kFreeEnd = 0xffffffffu;

struct LineChain {
    std::vector<glm::dvec2> points;
    std::vector<double> depths;       ///< One for each point.
    std::vector<LineSource> sources;  ///< One for each segment, the closing one included.
    bool is_closed = false;           ///< The first point is not repeated.
};

/// Joins pieces to polylines. Where more than two meet, the straightest pairs go on. Every piece is in one chain, once;
/// chains stand in the order of their first piece.
std::vector<LineChain> join_pieces(std::span<const LinePiece> pieces);

}  // namespace hw
