#include "hatchway/render/view/line_camera.hpp"

#include <algorithm>
#include <glm/trigonometric.hpp>

#include "hatchway/render/view/frame_block.hpp"

namespace hw {

LineCamera line_camera(const CameraPlace& place, const View& view)
{
    const glm::mat4& clip = view.clip_from_view;
    LineCamera camera{.eye_world = place.eye_world,
                      .target_world = place.target_world,
                      .fov_rad = glm::radians(place.fov_deg),
                      .orthographic_height_m = place.orthographic_height_m,
                      .size_px = view.size_px,
                      .near_m = clip[3][2] / (clip[2][2] - 1.0),
                      .roll_rad = glm::radians(place.roll_deg)};
    if (!view.is_orthographic()) return camera;
    const glm::vec2 range = depth_range(view);
    camera.near_m = std::max(0.0, static_cast<double>(range.x));
    camera.far_m = range.y;
    return camera;
}

}  // namespace hw
