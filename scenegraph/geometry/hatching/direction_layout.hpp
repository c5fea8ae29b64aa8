#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "hatchway/geometry/hatching/direction_field.hpp"

namespace hw {

/// Coordinates of each corner 3 f + c whose first rises along the field and whose second rises to the left of it, seen
/// from outside; continuous over sides that are not cut; metres as far as the surface allows.
std::vector<glm::vec2> lay_out(const WeldedMesh& mesh, const SmoothSides& sides, const DirectionField& field);

}  // namespace hw
