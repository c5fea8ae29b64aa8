#pragma once

#include <glm/vec3.hpp>

#include "hatchway/geometry/surface/surface.hpp"

namespace hw {

/// Whether a face is thinner than a thousandth of its length and the rounding of its corners to floats leaves its
/// normal open by more than 3 degrees: the pole of a sphere, a cap that lies almost on a line. True where all corners
/// lie on one line.
bool is_needle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// Gives every face that has no plane of its own (collinear, a needle, or a cap without a triangle) the plane of a face
/// that has one: the one that is reached over the longest sides. Winds it as the faces on that way. Fills
/// FacingFilter::inherited and counts in the report. Returns whether a face was turned over.
bool inherit_planes(Surface& surface);

}  // namespace hw
