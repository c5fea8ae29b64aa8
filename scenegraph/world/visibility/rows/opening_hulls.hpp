#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace hw {

/// A convex polygon that sight passes, metres.
using Opening = std::vector<glm::dvec3>;

/// Doubled area vector.
glm::dvec3 area_vector(const Opening& opening);

double area_of(const Opening& opening);

/// Openings of one plane as fewer: hulls of those whose hull adds little, or of what adds least where they are too
/// many.
std::vector<Opening> joined_by_hulls(std::vector<Opening> openings, const glm::dvec3& normal);

}  // namespace hw
