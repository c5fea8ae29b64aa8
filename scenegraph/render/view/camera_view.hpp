#pragma once

#include "hatchway/core/box.hpp"
#include "hatchway/style/view.hpp"

namespace hw {

struct CameraPlace {
    glm::dvec3 eye_world{0.0};
    glm::dvec3 target_world{0.0, 0.0, -1.0};
    double fov_deg = 60.0;  ///< Vertical.
};

/// The perspective view of a camera, y up. The depth range follows from the scene's bounds and the eye alone, never
/// from what is visible, so that pictures do not depend on the PVS. A target at the eye looks along -z.
View camera_view(const CameraPlace& camera, glm::ivec2 size_px, const Box& scene_bounds, float px_scale = 1.0f);

/// A camera from which the whole scene is seen, from the front and a little above.
CameraPlace overview_camera(const Box& scene_bounds, double aspect);

}  // namespace hw
