#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "hatchway/geometry/topology/directed_edges.hpp"

namespace hw {

/// Joins borders that run along each other and are cut at different places, as where a wall of
/// one quad stands on a floor of three: where corners of the one lie on an edge of the other, within `tolerance`, flat
/// faces between them ("caps") are appended to `faces`. They give every part of the border two faces, are never drawn
/// and have no plane of their own. Returns the number of edges that got caps. Positions that are only near a border by
/// chance, with no border along it, join nothing. Borders that run in the same direction, of a patch that is turned
/// over, and those of `two_sided_faces` (empty: none), which have no direction, are joined only where all that is
/// connected is closed by it.
std::uint32_t close_t_junctions(std::span<const glm::vec3> positions, std::vector<FaceCorners>& faces,
                                std::span<const DirectedEdge> uses, const std::vector<bool>& two_sided_faces,
                                float tolerance);

}  // namespace hw
