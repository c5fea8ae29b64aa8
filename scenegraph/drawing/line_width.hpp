#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "hatchway/geometry/lines/line_class.hpp"
#include "hatchway/style/line_look.hpp"

namespace hw {

/// What the width of a line at a place of it depends on beside the look.
struct PenPlace {
    LineClass line_class = LineClass::silhouette;
    float fold_rad = 0.0f;     ///< Of creases.
    float distance_m = 1.0f;   ///< From the eye.
    float px_per_m = 1.0f;     ///< Of the picture, there.
    float window_m = 1.0f;     ///< LineCrowding::window() in the world.
    glm::vec4 crowding{0.0f};  ///< LineCrowding there.
    float inside = 0.0f;       ///< insideness()
};

/// 1 where both faces beside a line show the same side: it is drawn inside of the object. 0 where it is an outline now,
/// or faces are not known (their normals are zero). A line that turns from the one to the other does so over some
/// degrees.
/// `to_eye`: from the line, any length.
float insideness(const glm::vec3& normal_a, const glm::vec3& normal_b, const glm::vec3& to_eye);

/// The width in pixels with which a look draws a line before presence and taper of strokes: by class, fold, distance
/// and crowding. `crease_rad`: of the style's needs. shaders/lines/line_width.glsl computes the same; a test compares
/// them.
double line_width_px(const LineLook& look, float crease_rad, const PenPlace& place);

}  // namespace hw
