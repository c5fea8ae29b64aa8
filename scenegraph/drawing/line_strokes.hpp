#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "hatchway/style/line_look.hpp"

namespace hw {

/// Where a line lies on the stroke that a hand would draw it in: the chain of lines of one class that run on into each
/// other. Object space.
struct LineStroke {
    float from = 0.0f;    ///< Length along the stroke at the line's first end.
    float to = 0.0f;      ///< ... at its second.
    float length = 0.0f;  ///< Of the stroke; below zero: minus the length of a closed one, which has no ends.
    float seed = 0.0f;    ///< In [0, 1), of the place where the stroke begins: no two strokes are drawn alike.
};

struct StrokeSegment {
    std::array<glm::vec3, 2> ends;
    LineClass line_class;
};

/// Joins lines to strokes: at places where exactly two of a class meet and turn by less than about 35 degrees. One
/// result for each, in order.
std::vector<LineStroke> find_strokes(std::span<const StrokeSegment> segments);

}  // namespace hw
