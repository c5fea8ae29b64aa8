#pragma once

#include <glm/vec2.hpp>

#include "hatchway/core/box.hpp"
#include "hatchway/render/view/visible_set.hpp"

namespace hw {

/// How many pixels of a picture an object's ranges cover, each triangle for itself, hidden or not: what a software
/// renderer's time grows with. `facing`: which way the triangles wind that are drawn, 1 or -1, or 0 for both.
double covered_pixels(const MeshData& mesh, std::span<const IndexRange> ranges, const glm::mat4& clip_from_object,
                      float facing, glm::ivec2 size_px);

/// At least as many as that, without looking at triangles: from a mesh's area and bounds, in object space. Infinite
/// where the bounds reach behind the eye.
double most_covered_pixels(double area, const Box& bounds, const glm::mat4& clip_from_object, glm::ivec2 size_px);

}  // namespace hw
