#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "hatchway/geometry/lines/line_class.hpp"
#include "hatchway/world/presence.hpp"

namespace hw {

/// How far objects keep from turning black: where lines of an object come closer together on the screen than
/// `full_spacing_px`, they are drawn the thinner the closer they are, all of them with as much ink as lines so far
/// apart: an object keeps that tone however far away it goes. Lines inside of it, both of whose faces are seen, go
/// first and leave its outline.
struct FarPolicy {
    static constexpr float kInnerGone = 1.0f / 3.0f;  ///< Share of the width at which lines inside are gone.

    bool is_on = true;
    float full_spacing_px = 4.0f;  ///< Above 0; logical pixels.
};

/// How a hand departs from a ruler; all zero: ruled lines. Lengths are logical pixels. Creases, borders, artist's edges
/// and intersections go by the length along the stroke on the object and a seed of the place where it begins;
/// smooth silhouettes by noise in the object's space, and they are never dashed, tapered or overshot: nothing boils
/// when the eye moves.
struct StrokeCharacter {
    float wobble_px = 0.0f;     ///< How far a stroke strays sideways.
    float bend_px = 40.0f;      ///< From one bend to the next, about.
    float overshoot_px = 0.0f;  ///< How far a stroke runs on beyond its ends, at most.
    float taper_px = 0.0f;      ///< Over which a stroke's ends grow thin.
    float dash_px = 0.0f;       ///< A dash with its gap, about; 0: unbroken.
    float dash_share = 0.6f;    ///< Of the dash in that, in (0, 1].

    bool is_ruled() const { return wobble_px == 0.0f && overshoot_px == 0.0f && taper_px == 0.0f && dash_px == 0.0f; }
};

/// What draws the lines of one class.
struct Pen {
    float width_px = 1.2f;   ///< Logical pixels.
    glm::vec3 colour{0.0f};  ///< sRGB
    bool is_drawn = true;
};

/// How lines are drawn: look.all({.width_px = 2.0f}), then look[LineClass::border] = {.width_px = 3.0f}. Which edges
/// are creases is EdgeNeed's.
struct LineLook {
    /// Of each class, in the order of LineClass: silhouettes and borders are the wider ones.
    std::array<Pen, kLineClassCount> pens{Pen{1.5f}, Pen{}, Pen{}, Pen{1.5f}, Pen{}, Pen{}};
    float depth_taper = 0.0f;  ///< 0: constant width; 1: width falls as 1 / distance beyond `taper_from_m`.
    float taper_from_m = 10.0f;
    /// 1: creases grow from a quarter of their width, just folded enough, to all of it at a right angle.
    float fold_weight = 0.0f;
    StrokeCharacter stroke;
    FarPolicy far;
    PresenceField share;  ///< How much of the lines is there, by height and time: times the item's presence.

    Pen& operator[](LineClass line_class) { return pens[static_cast<std::size_t>(line_class)]; }
    const Pen& operator[](LineClass line_class) const { return pens[static_cast<std::size_t>(line_class)]; }
    LineLook& all(const Pen& pen)
    {
        pens.fill(pen);
        return *this;
    }
};

}  // namespace hw
