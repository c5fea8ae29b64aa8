#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "hatchway/geometry/topology/directed_edges.hpp"

namespace hw {

/// Joins pairs of border edges that run in opposite directions and whose ends are at most `tolerance` apart, by giving
/// their ends one position (that of the smaller id). Never makes two corners of a face equal; edges shorter than twice
/// the tolerance are left alone. Returns the number of pairs. Positions that nothing uses any more stay in the list.
std::uint32_t stitch_borders(std::span<const glm::vec3> positions, std::vector<FaceCorners>& faces,
                             std::span<const DirectedEdge> uses, float tolerance);

}  // namespace hw
