#pragma once

#include "hatchway/render/loaded_scene.hpp"
#include "hatchway/render/view/visible_set.hpp"

namespace hw {

/// From so many layers of faces on it pays to ask which are seen.
inline constexpr double kDeepLayers = 64.0;

/// How many times a picture's pixels are drawn at the mean, hidden or not: a small file can lay thousands of faces over
/// each other, and a software renderer looks at each. A layer is what a hidden opaque face costs.
struct FrameCost {
    double face_layers = 0.0;
    double line_layers = 0.0;

    bool is_deep() const { return face_layers > kDeepLayers; }
    /// More samples would take as long as a software renderer may.
    bool wants_one_sample() const { return face_layers > 1000.0; }
};

/// Of what is visible, in its styles, with `image_count` images beside the picture. A line's length follows from the
/// size of its object in the picture.
FrameCost frame_cost(const LoadedScene& scene, const VisibleSet& visible, std::size_t image_count, glm::ivec2 size_px);

}  // namespace hw
