#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <span>

#include "hatchway/core/box.hpp"
#include "hatchway/style/view.hpp"
#include "hatchway/world/mirrors.hpp"

namespace hw {

/// A rectangle of a picture, in normalised device coordinates. The default is all of it.
struct PictureWindow {
    glm::dvec2 min{-1.0};
    glm::dvec2 max{1.0};
};

/// The part of a view's picture, within `window`, that holds all of a convex polygon that the near plane leaves; none
/// where the polygon is out of it.
std::optional<PictureWindow> window_of(std::span<const glm::dvec3> outline_world, const View& view,
                                       const PictureWindow& window);

/// The window with room for wide lines, and for styles that look at the pixels around, in the picture of `view`.
PictureWindow with_room(const PictureWindow& window, const View& view);

/// What the eye of `view`, in front of the plane, sees in it: the view from the eye's reflection, in which everything
/// stands in the picture where it is seen in the mirror. The plane takes the place of the near plane (Lengyel 2005), so
/// nothing behind the mirror is in the view, on devices with and without clip distances. There is no far plane. Depth
/// is as fine as within `window` it can be. `scene_bounds`: world space; a parallel projection's depth reaches as far.
View reflected_view(const View& view, const MirrorPlane& plane, const PictureWindow& window, const Box& scene_bounds);

}  // namespace hw
