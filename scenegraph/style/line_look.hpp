#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "hatchway/geometry/lines/line_class.hpp"
#include "hatchway/param/param_visitor.hpp"

namespace hw {

/// How far objects keep from turning black: where lines of an object come closer together on the screen than
/// `full_spacing_px`, they are drawn the thinner the closer they are, all of them with as much ink as lines so far
/// apart: an object keeps that tone however far away it goes. Lines inside of it, both of whose faces are seen, go
/// first and leave its outline.
struct FarPolicy {
    static constexpr float kInnerGone = 1.0f / 3.0f;  ///< Share of the width at which lines inside are gone.

    bool is_on = true;
    float full_spacing_px = 4.0f;  ///< Above 0; logical pixels.

    void visit_params(ParamVisitor& visitor)
    {
        visitor.flag({"far_thinning", "Thins crowded lines of far objects, so that they do not turn black."}, is_on);
        visitor.real({"far_spacing_px", "Lines of an object that come closer together than this are thinned."},
                     full_spacing_px, 1.0f, 40.0f);
    }
};

/// How a hand departs from a ruler; all zero: ruled lines. Lengths are logical pixels. Creases, borders, artist's edges
/// and intersections go by the length along the stroke on the object and a seed of the place where it begins;
/// silhouettes by noise in the object's space, and they are never dashed, tapered or overshot: nothing boils when the
/// eye moves.
struct StrokeCharacter {
    float wobble_px = 0.0f;     ///< How far a stroke strays sideways.
    float bend_px = 40.0f;      ///< From one bend to the next, about.
    float overshoot_px = 0.0f;  ///< How far a stroke runs on beyond its ends, at most.
    float taper_px = 0.0f;      ///< Over which a stroke's ends grow thin.
    float dash_px = 0.0f;       ///< A dash with its gap, about; 0: unbroken.
    float dash_share = 0.6f;    ///< Of the dash in that, in (0, 1].

    bool is_ruled() const { return wobble_px == 0.0f && overshoot_px == 0.0f && taper_px == 0.0f && dash_px == 0.0f; }
};

/// How lines are drawn. Widths are logical pixels.
struct LineLook {
    std::array<float, kLineClassCount> width_px{1.5f, 1.2f, 1.2f, 1.5f, 1.2f, 1.2f};
    std::array<glm::vec3, kLineClassCount> colour{};  ///< sRGB
    std::array<bool, kLineClassCount> is_drawn{true, true, true, true, true, true};
    float crease_rad = 0.7f;   ///< Must not exceed EdgeNeed's: the prefix of the edge table that is drawn.
    float depth_taper = 0.0f;  ///< 0: constant width; 1: width falls as 1 / distance beyond `taper_from_m`.
    float taper_from_m = 10.0f;
    float fold_weight =
        0.0f;  ///< 1: creases grow from a quarter of their width, just folded enough, to all at a right angle.
    StrokeCharacter stroke;
    FarPolicy far;
};

}  // namespace hw
