#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "hatchway/geometry/topology/directed_edges.hpp"
#include "hatchway/geometry/topology/doubled_faces.hpp"

namespace hw {

/// Sheets that are modelled from both sides and cut into triangles in another way on each. A patch are faces connected
/// over edges of exactly two faces that do not fold back there. Two patches with the same border are one sheet where
/// both lie in one plane within `tolerance`, or where both have all their corners on the border and bend little, as
/// two halves of a quad along one diagonal or the other, and hang on others at two edges at least. The patch stays
/// that has the first triangle.
///
/// Looks only at patches of at most 1024 faces at edges of three faces or more: meshes without such edges cost nothing,
/// and a flat polygon alone that is doubled stays as it is.
DoubledFaces find_doubled_patches(std::span<const glm::vec3> positions, std::span<const FaceCorners> faces,
                                  std::span<const DirectedEdge> uses, std::span<const std::uint32_t> face_triangle,
                                  float tolerance);

}  // namespace hw
