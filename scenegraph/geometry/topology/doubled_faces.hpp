#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hatchway/geometry/topology/directed_edges.hpp"

namespace hw {

/// Faces that have the same three corners as another face.
struct DoubledFaces {
    std::vector<bool> is_dropped;    ///< Repeats a face that stays; empty when no face does.
    std::vector<bool> is_two_sided;  ///< Of faces that stay: one that is dropped winds the other way.
};

/// Of faces with the same corners the one stays whose triangle is the first: a sheet that is modelled from both sides
/// is one sheet that is seen from both. `face_triangle`: where each face came from.
DoubledFaces find_doubled_faces(std::span<const FaceCorners> faces, std::span<const DirectedEdge> uses,
                                std::span<const std::uint32_t> face_triangle);

}  // namespace hw
