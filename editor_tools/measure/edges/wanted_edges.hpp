#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "measure/lines/exact_lines.hpp"

namespace hw {

/// What an edge map ought to make of a place on an exact line.
enum class EdgeKind : std::uint8_t {
    profile,  ///< One of two faces looks away, or there is one alone; behind lies nothing, or what is kGap farther.
    flush,    ///< The same, and what lies behind is nearer than that: a depth image can hardly know.
    inner,    ///< A crease both of whose faces are seen.
    other,    ///< Marked by the artist, or where objects cut each other: explains an edge, is not asked for.
};
inline constexpr int kEdgeKindCount = 4;
inline constexpr double kGap = 0.01;  ///< Share of the distance.

/// A short piece of a line, all of one kind.
struct WantedEdge {
    glm::dvec2 at_px{0.0};   ///< Its middle; origin top left, y down.
    glm::dvec2 across{0.0};  ///< Unit.
    double length_px = 0.0;  ///< Half a pixel at most.
    EdgeKind kind = EdgeKind::other;
};

/// The exact visible lines of a view in perspective. Facing is decided anew from the faces' corners, depth behind a
/// line by rays half a pixel beside it.
std::vector<WantedEdge> wanted_edges(const ExactLines& lines, const CameraPlace& camera, glm::ivec2 size_px);

}  // namespace hw
