#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace hw {

/// Appends triangles of a polygon to `triangles`: three numbers of its corners each, in the polygon's winding, always
/// corners - 2 triangles, nothing for fewer than three corners.
///
/// The polygon may be concave and need not be flat: it is judged as seen along its area vector. One that crosses itself
/// or has no area still gives its number of triangles; which ones is then arbitrary. A convex polygon becomes a fan
/// from its first corner. Time: corners times concave corners.
/// Source: Meisters. Polygons Have Ears. American Mathematical Monthly 82(6), 1975.
void triangulate(std::span<const glm::vec3> polygon, std::vector<std::uint32_t>& triangles);

}  // namespace hw
