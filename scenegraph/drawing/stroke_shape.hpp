#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "hatchway/drawing/line_strokes.hpp"

namespace hw {

/// How a look's hand departs from a ruler at places of strokes. shaders/lines/line_stroke.glsl draws the same, with the
/// same seeds. Lengths along strokes are the object's units; `px_per_unit`: pixels for one of them at the place.
class StrokeShape {
 public:
    explicit StrokeShape(const StrokeCharacter& character) : character_(character) {}

    bool is_ruled() const { return character_.is_ruled(); }
    bool is_dashed() const { return character_.dash_px > 0.0f; }
    /// No noise changes much over so many pixels.
    double step_px() const;

    /// Pixels to the left of the way in which the length along the stroke rises, as seen with y up.
    double stray(float arc, float seed, float px_per_unit) const;
    /// Of silhouettes: pixels in the picture's plane, y up, at a place of the object.
    glm::dvec2 silhouette_stray(const glm::vec3& place, float px_per_unit) const;
    /// The share of its width that a stroke has near its ends.
    double taper(const LineStroke& stroke, float arc, float px_per_unit) const;
    /// How many pixels a line runs on beyond an end of it: 0 but where its stroke ends there. `end`: 0 or 1.
    double overshoot_px(const LineStroke& stroke, int end) const;

    /// A dash with its gap, in units.
    float dash_period(float px_per_unit) const;
    /// Where in a dash a place is, in [0, 1): ink up to dash_share().
    float dash_phase(float arc, float seed, float period) const;
    float dash_share() const { return character_.dash_share; }

 private:
    StrokeCharacter character_;
};

}  // namespace hw
