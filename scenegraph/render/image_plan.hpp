#pragma once

#include <set>
#include <vector>

#include "hatchway/render/frame_plan.hpp"
#include "hatchway/render/loaded_scene.hpp"

namespace hw {

/// An image that a frame makes.
struct WantedImage {
    ImageKey key;
    std::set<int> styles;   ///< Those that need it, themselves or by another image.
    bool is_shown = false;  ///< It is looked at, itself or by another image: whatever is visible belongs in it.
};

/// The images that visible styles need and, where there is one, the image that is looked at. Each once, after all that
/// it reads itself.
std::vector<WantedImage> plan_images(const LoadedScene& scene, const FramePlan& plan, const ImageKey* shown);

/// The visible objects whose styles need an image: opaque ones near before far, then blended ones back to front.
std::vector<DrawItem> items_of(const WantedImage& image, const SceneInput& input, const WholeItems& visible);

}  // namespace hw
