#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "hatchway/geometry/topology/directed_edges.hpp"

namespace hw {

/// Makes a point of every hole that is smaller than `share` of the piece of surface around it, or than what a float
/// tells at its place, as at the pole of a globe whose angles are floats: all corners at its border get one position,
/// that of the smallest id, and the faces along it have two equal corners then, which the caller removes. A hole is
/// left alone where a face would lose all corners, where no face would stay around the point, or where the point would
/// have edges of more than two faces. A piece is what hangs together by common corners, so that small pieces beside
/// large ones keep their shape. Returns the number of holes.
std::uint32_t close_pinholes(std::span<const glm::vec3> positions, std::vector<FaceCorners>& faces,
                             std::span<const DirectedEdge> uses, float share);

}  // namespace hw
