#pragma once

#include <vector>

#include "hatchway/render/frame_plan.hpp"
#include "hatchway/render/loaded_scene.hpp"

namespace hw {

/// An image that a frame makes.
struct WantedImage {
    ImageKey key;
    bool is_shown = false;  ///< It is looked at, itself or by another image: whatever is visible belongs in it.
};

/// The images that visible styles need and, where there is one, the image that is looked at. Each once, after all that
/// it reads itself.
std::vector<WantedImage> plan_images(const LoadedScene& scene, const FramePlan& plan, const ImageKey* shown);

/// The visible objects whose styles need an image, or all that are visible: opaque ones near before far, then blended
/// ones back to front.
std::vector<DrawItem> items_of(const NeededImage& image, bool is_shown, const SceneInput& input,
                               const WholeItems& visible);

/// Pass::depth_range(). Of all objects where no style needs the image: it is only looked at.
DepthRange depth_range_of(const NeededImage& image, const SceneInput& input, const View& view);

}  // namespace hw
