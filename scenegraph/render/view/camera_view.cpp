#include "hatchway/render/view/camera_view.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace hw {
namespace {

double farthest_corner(const Box& box, const glm::dvec3& eye)
{
    return glm::length(glm::max(glm::abs(box.min - eye), glm::abs(box.max - eye)));
}

double distance_to(const Box& box, const glm::dvec3& eye)
{
    return glm::length(glm::max(glm::max(box.min - eye, eye - box.max), glm::dvec3(0.0)));
}

glm::dvec3 direction_of(const CameraPlace& camera)
{
    const glm::dvec3 direction = camera.target_world - camera.eye_world;
    const double length = glm::length(direction);
    return length > 0.0 && std::isfinite(length) ? direction / length : glm::dvec3(0.0, 0.0, -1.0);
}

glm::dmat4 perspective_projection(const CameraPlace& camera, double aspect, const Box& bounds)
{
    const double diagonal = std::max(glm::length(bounds.size()), 1e-9);
    const double far_plane = std::max(farthest_corner(bounds, camera.eye_world) * 1.01, diagonal * 1e-3);
    const double closest = std::max(std::min(0.05, diagonal * 2e-3), far_plane * 1e-5);
    const double near_plane = std::max(closest, 0.5 * distance_to(bounds, camera.eye_world));
    return glm::perspective(glm::radians(camera.fov_deg), aspect, near_plane, far_plane);
}

/// From the scene's nearest depth before the eye to its farthest, with a little room at both ends.
glm::dmat4 parallel_projection(const CameraPlace& camera, double aspect, const glm::dvec3& direction, const Box& bounds)
{
    const double middle = glm::dot(bounds.centre() - camera.eye_world, direction);
    const double half = 0.5 * glm::dot(glm::abs(direction), bounds.size());
    const double room = std::max(1e-3 * half, 1e-6 * *camera.orthographic_height_m);
    const double near_plane = std::max(0.0, middle - half - room);
    const double far_plane = std::max(middle + half + room, near_plane + room);
    const double y = 0.5 * *camera.orthographic_height_m, x = y * aspect;
    return glm::ortho(-x, x, -y, y, near_plane, far_plane);
}

}  // namespace

CameraPlace camera_place(const Camera& camera)
{
    return {camera.eye_world, camera.target_world, camera.fov_deg, camera.orthographic_height_m};
}

View camera_view(const CameraPlace& camera, glm::ivec2 size_px, const Box& scene_bounds, float px_scale)
{
    const Box bounds = scene_bounds.is_empty() ? Box{glm::dvec3(-1.0), glm::dvec3(1.0)} : scene_bounds;
    const glm::dvec3 direction = direction_of(camera);
    // Looking straight up or down, -z (or +z) is up in the picture: the limit of tilting the head.
    const bool is_vertical = std::abs(direction.y) > 0.999999;
    const glm::dvec3 up =
        is_vertical ? glm::dvec3(0.0, 0.0, direction.y > 0.0 ? 1.0 : -1.0) : glm::dvec3(0.0, 1.0, 0.0);
    const double aspect = static_cast<double>(size_px.x) / std::max(size_px.y, 1);
    View view;
    view.view_from_world = glm::mat4(glm::lookAt(camera.eye_world, camera.eye_world + direction, up));
    view.clip_from_view =
        glm::mat4(camera.orthographic_height_m ? parallel_projection(camera, aspect, direction, bounds)
                                               : perspective_projection(camera, aspect, bounds));
    view.eye_world = camera.eye_world;
    if (camera.orthographic_height_m) {
        view.to_viewer_world = camera.eye_world - camera.target_world;
        if (view.to_viewer_world == glm::dvec3(0.0)) view.to_viewer_world = -direction;
    }
    view.size_px = size_px;
    view.px_scale = px_scale;
    return view;
}

CameraPlace overview_camera(const Box& scene_bounds, double aspect)
{
    CameraPlace camera;
    if (scene_bounds.is_empty()) return camera;
    const double slope = std::tan(glm::radians(camera.fov_deg) / 2.0);
    const double radius = std::max(0.5 * glm::length(scene_bounds.size()), 1e-9);
    const double distance = 0.85 * radius / std::sin(std::atan(slope * std::min(aspect, 1.0)));
    camera.target_world = scene_bounds.centre();
    camera.eye_world = camera.target_world + distance * glm::normalize(glm::dvec3(0.55, 0.4, 1.0));
    return camera;
}

}  // namespace hw
