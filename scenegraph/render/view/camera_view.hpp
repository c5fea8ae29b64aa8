#pragma once

#include <optional>
#include <span>

#include "hatchway/core/box.hpp"
#include "hatchway/style/view.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

struct CameraPlace {
    glm::dvec3 eye_world{0.0};
    glm::dvec3 target_world{0.0, 0.0, -1.0};
    double fov_deg = 60.0;                             ///< Vertical.
    std::optional<double> orthographic_height_m = {};  ///< A parallel projection so high, in place of the angle.
    double roll_deg = 0.0;                             ///< About the line of sight: see picture_up().
};

CameraPlace camera_place(const Camera& camera);

/// The view of a camera; picture_up() is up. The depth range follows from where the scene lies (find_places()) and the
/// eye alone, never from what is visible, so that pictures do not depend on the PVS. What lies far away, or is far
/// larger than all that is near, does not move the near plane; a perspective has no far plane then. A target at the eye
/// looks along -z. In a parallel projection, too, what is behind the eye is not seen; there is_beyond() tells what lies
/// too deep.
View camera_view(const CameraPlace& camera, glm::ivec2 size_px, std::span<const Box> boxes_world,
                 float px_scale = 1.0f);
View camera_view(const CameraPlace& camera, glm::ivec2 size_px, const Box& scene_bounds, float px_scale = 1.0f);

/// Whether a parallel projection would show something of the box, did it not lie beyond its far plane: more than ten
/// thousand times as deep as the picture is high, where depth would be coarser than what is seen.
bool is_beyond(const View& view, const Box& box_world);

/// A camera from which the whole scene is seen, from the front and a little above.
CameraPlace overview_camera(const Box& scene_bounds, double aspect);

}  // namespace hw
