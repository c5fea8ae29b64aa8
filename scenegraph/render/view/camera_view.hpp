#pragma once

#include <optional>

#include "hatchway/core/box.hpp"
#include "hatchway/style/view.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

struct CameraPlace {
    glm::dvec3 eye_world{0.0};
    glm::dvec3 target_world{0.0, 0.0, -1.0};
    double fov_deg = 60.0;                             ///< Vertical.
    std::optional<double> orthographic_height_m = {};  ///< A parallel projection so high, in place of the angle.
};

CameraPlace camera_place(const Camera& camera);

/// The view of a camera, y up. The depth range follows from the scene's bounds and the eye alone, never
/// from what is visible, so that pictures do not depend on the PVS. A target at the eye looks along -z. In a parallel
/// projection, too, what is behind the eye is not seen.
View camera_view(const CameraPlace& camera, glm::ivec2 size_px, const Box& scene_bounds, float px_scale = 1.0f);

/// A camera from which the whole scene is seen, from the front and a little above.
CameraPlace overview_camera(const Box& scene_bounds, double aspect);

}  // namespace hw
