#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "hatchway/geometry/topology/directed_edges.hpp"

namespace hw {

/// Sheets that are modelled from both sides whose sides are at most `tolerance` apart, as where numbers were rounded:
/// gives positions of one side to the other where faces are doubled by it (find_doubled_faces(),
/// find_doubled_patches()), and nowhere else. Looks only where a border lies on a border and both faces lie on one side
/// of it; connected parts with an edge shorter than twice the tolerance, such as the rim of a thin plate, are left
/// alone, as is a mesh that got more edges of three faces. Returns whether faces changed. Positions that nothing uses
/// any more stay in the list.
bool join_near_doubles(std::span<const glm::vec3> positions, std::vector<FaceCorners>& faces,
                       std::span<const DirectedEdge> uses, std::span<const std::uint32_t> face_triangle,
                       float tolerance);

}  // namespace hw
