#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "hatchway/geometry/surface/smooth_sides.hpp"

namespace hw {

/// A direction on each face, and how directions fit together over its sides.
struct DirectionField {
    std::vector<glm::vec3> along;      ///< Unit, in the face's plane; zero where the face has none.
    std::vector<bool> is_cut;          ///< Sides over which directions or coordinates cannot be continued.
    std::vector<std::uint32_t> piece;  ///< Of each face: faces joined over sides that are not cut.
    std::uint32_t singularities = 0;
};

/// Directions of strongest curvature, smoothed where the surface says little, and turned so that they run on over every
/// side that is not cut. Pieces are discs: each side is cut that is a crease, lies between singular points, or opens a
/// ring. Where there is no curvature at all, directions are level.
DirectionField principal_field(const WeldedMesh& mesh, const SmoothSides& sides);

}  // namespace hw
