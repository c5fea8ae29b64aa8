#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace hw {

struct Segment3 {
    glm::dvec3 a{0.0};
    glm::dvec3 b{0.0};
};

/// A pair of nearest points; equal where the segment meets the triangle.
struct NearestPoints {
    glm::dvec3 on_segment{0.0};
    glm::dvec3 on_triangle{0.0};
};

/// The nearest points of a segment (its ends may be equal) and a triangle of positive area.
/// Source: Ericson. Real-Time Collision Detection. 2005, section 5.1.
NearestPoints nearest_points(const Segment3& segment, const std::array<glm::dvec3, 3>& triangle);

}  // namespace hw
