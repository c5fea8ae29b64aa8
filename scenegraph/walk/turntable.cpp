#include "walk/turntable.hpp"

#include <cmath>

#include "render/camera_view.hpp"

namespace hw {
namespace {

constexpr double kSeconds = 10.0;
constexpr int kKeys = 24;  // Catmull-Rom through 24 places leaves the circle by less than a ten-thousandth of its radius

}  // namespace

CameraPath turntable(const Box& bounds_world, double aspect)
{
    // The box that is as wide in all directions as the scene's diagonal fits in every view of the turn.
    Box turned = bounds_world;
    if (!bounds_world.is_empty()) {
        const double half = 0.5 * std::hypot(bounds_world.size().x, bounds_world.size().z);
        turned.min.x = bounds_world.centre().x - half;
        turned.max.x = bounds_world.centre().x + half;
        turned.min.z = bounds_world.centre().z - half;
        turned.max.z = bounds_world.centre().z + half;
    }
    const CameraPlace start = overview_camera(turned, aspect);
    const glm::dvec3 arm = start.eye_world - start.target_world;

    CameraPath path;
    path.fov_deg = start.fov_deg;
    for (int i = 0; i <= kKeys; ++i) {
        const double angle = glm::radians(360.0) * (i % kKeys) / kKeys;
        const glm::dvec3 turned_arm(std::cos(angle) * arm.x + std::sin(angle) * arm.z, arm.y,
                                    std::cos(angle) * arm.z - std::sin(angle) * arm.x);
        path.keys.push_back({.t_s = kSeconds * i / kKeys,
                             .position = start.target_world + turned_arm,
                             .look_at = start.target_world});
    }
    return path;
}

}  // namespace hw
