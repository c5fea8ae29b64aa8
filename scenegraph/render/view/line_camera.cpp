#include "hatchway/render/view/line_camera.hpp"

#include <glm/trigonometric.hpp>

namespace hw {

LineCamera line_camera(const CameraPlace& place, const View& view)
{
    const glm::mat4& clip = view.clip_from_view;
    return {.eye_world = place.eye_world,
            .target_world = place.target_world,
            .fov_rad = glm::radians(place.fov_deg),
            .size_px = view.size_px,
            .near_m = clip[3][2] / (clip[2][2] - 1.0)};
}

}  // namespace hw
