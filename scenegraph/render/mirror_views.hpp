#pragma once

#include <vector>

#include "hatchway/render/frame.hpp"
#include "hatchway/render/view/mirror_view.hpp"

namespace hw {

/// Of a frame, those within others counted: mirrors of a stranger's level may see each other without end.
inline constexpr int kMostMirrorViews = 32;

/// A mirror that is seen in a view, from the side from which it is drawn.
struct MirrorInView {
    const Mirror* mirror = nullptr;
    MirrorPlane plane;     ///< Its front is where the eye is.
    PictureWindow window;  ///< Where it is in the picture, with room.
};

/// The mirrors among the visible objects, near before far.
std::vector<MirrorInView> mirrors_in(const SceneInput& input, const VisibleSet& visible, const View& view,
                                     const PictureWindow& window);

/// Lays what the mirrors show over their faces, which have been drawn.
void draw_reflections(const Frame& frame);

}  // namespace hw
