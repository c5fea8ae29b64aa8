#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace hw {

/// Where rectangles stand in a strip, and how high it is filled.
struct Packing {
    std::vector<glm::ivec2> corners;  ///< One for each rectangle, its corner of least x and y.
    int height = 0;
};

/// Puts rectangles side by side in rows, tall ones first, in a strip of `width`, which is at least the widest. They do
/// not overlap. The same sizes give the same places.
Packing pack_in_rows(std::span<const glm::ivec2> sizes, int width);

}  // namespace hw
