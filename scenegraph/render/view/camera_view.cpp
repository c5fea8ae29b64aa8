#include "hatchway/render/view/camera_view.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "hatchway/geometry/picture_up.hpp"
#include "hatchway/world/scene_places.hpp"

namespace hw {
namespace {

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

struct Range {
    double near_plane;
    double far_plane;
};

double width(const Box& box)
{
    return std::max(glm::length(box.size()), 1e-9);
}

/// How close things may come that fill `bounds`.
double closest(const Box& bounds)
{
    return std::min(0.05, width(bounds) * 2e-3);
}

/// Of things that lie together.
Range perspective_range(const Box& bounds, const glm::dvec3& eye)
{
    const double far_plane = std::max(farthest(bounds, eye) * 1.01, width(bounds) * 1e-3);
    const double near_plane = std::max(closest(bounds), far_plane * 1e-5);
    return {std::max(near_plane, 0.5 * distance_to(bounds, eye)), far_plane};
}

/// The nearest things that lie together, as the eye sees them, decide as if there were no others. Of the others, which
/// are many times farther away or many times larger, each decides for itself.
Range perspective_range(std::span<const Box> boxes, const glm::dvec3& eye)
{
    constexpr double kApart = 30.0;
    std::vector<double> reach;
    for (const Box& box : boxes) reach.push_back(farthest(box, eye));
    const double end = end_of_group(reach, 0.0, kApart);
    Box together, all;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        all.add(boxes[i]);
        if (reach[i] <= end) together.add(boxes[i]);
    }
    Range range = perspective_range(together, eye);
    for (std::size_t i = 0; i < boxes.size(); ++i)
        if (reach[i] > end)
            range.near_plane = std::min(range.near_plane, std::max(closest(all), 0.5 * distance_to(boxes[i], eye)));
    return {range.near_plane, perspective_range(all, eye).far_plane};
}

/// Where floats hold no far plane there is none, and what is infinitely far away is a step nearer than a cleared depth.
glm::dmat4 perspective_projection(const CameraPlace& camera, double aspect, std::span<const Box> boxes)
{
    constexpr double kMostRange = 1.05e5;
    constexpr double kStep = 1.0 / (1 << 22);
    const Range range = perspective_range(boxes, camera.eye_world);
    const double angle = glm::radians(camera.fov_deg);
    glm::dmat4 projection = glm::perspective(angle, aspect, range.near_plane, range.far_plane);
    if (range.far_plane <= kMostRange * range.near_plane) return projection;
    projection[2][2] = kStep - 1.0;
    projection[3][2] = (kStep - 2.0) * range.near_plane;
    return projection;
}

/// From a box's nearest depth before the eye to its farthest, with a little room at both ends.
Range parallel_range(const Box& box, const CameraPlace& camera, const glm::dvec3& direction)
{
    const double middle = glm::dot(box.centre() - camera.eye_world, direction);
    const double half = 0.5 * glm::dot(glm::abs(direction), box.size());
    const double room = std::max(1e-3 * half, 1e-6 * *camera.orthographic_height_m);
    const double near_plane = std::max(0.0, middle - half - room);
    return {near_plane, std::max(middle + half + room, near_plane + room)};
}

/// Everything, or where depth would be coarse then, what is nearest before the eye as far as depth is fine.
Range parallel_range(std::span<const Box> boxes, const CameraPlace& camera, const glm::dvec3& direction)
{
    constexpr double kFineDepth = 1e4;  // times the picture's height: 24 bits tell a pixel of a thousand
    Box all;
    for (const Box& box : boxes) all.add(box);
    const Range whole = parallel_range(all, camera, direction);
    const double deepest = kFineDepth * *camera.orthographic_height_m;
    if (whole.far_plane - whole.near_plane <= deepest) return whole;
    std::vector<Range> ranges;
    for (const Box& box : boxes)
        if (glm::dot(box.centre() - camera.eye_world, direction) + 0.5 * glm::dot(glm::abs(direction), box.size()) >=
            0.0)
            ranges.push_back(parallel_range(box, camera, direction));
    if (ranges.empty()) return whole;
    std::ranges::sort(ranges, {}, &Range::near_plane);
    Range fine{ranges[0].near_plane, ranges[0].near_plane};
    for (const Range& range : ranges)
        if (range.near_plane < fine.near_plane + deepest)
            fine.far_plane = std::max(fine.far_plane, std::min(range.far_plane, fine.near_plane + deepest));
    return fine;
}

glm::dmat4 parallel_projection(const CameraPlace& camera, double aspect, const glm::dvec3& direction,
                               std::span<const Box> boxes)
{
    const Range range = parallel_range(boxes, camera, direction);
    const double y = 0.5 * *camera.orthographic_height_m, x = y * aspect;
    return glm::ortho(-x, x, -y, y, range.near_plane, range.far_plane);
}

}  // namespace

CameraPlace camera_place(const Camera& camera)
{
    return {camera.eye_world, camera.target_world, camera.fov_deg, camera.orthographic_height_m, camera.roll_deg};
}

View camera_view(const CameraPlace& camera, glm::ivec2 size_px, const Box& scene_bounds, float px_scale)
{
    return camera_view(camera, size_px, std::span(&scene_bounds, scene_bounds.is_empty() ? 0 : 1), px_scale);
}

View camera_view(const CameraPlace& camera, glm::ivec2 size_px, std::span<const Box> boxes_world, float px_scale)
{
    const Box nothing{glm::dvec3(-1.0), glm::dvec3(1.0)};
    const std::span<const Box> boxes = boxes_world.empty() ? std::span(&nothing, 1) : boxes_world;
    const glm::dvec3 direction = direction_of(camera);
    const glm::dvec3 up = picture_up(direction, glm::radians(camera.roll_deg));
    const double aspect = static_cast<double>(size_px.x) / std::max(size_px.y, 1);
    View view;
    view.view_from_world = glm::mat4(glm::lookAt(camera.eye_world, camera.eye_world + direction, up));
    view.clip_from_view = glm::mat4(camera.orthographic_height_m ? parallel_projection(camera, aspect, direction, boxes)
                                                                 : perspective_projection(camera, aspect, boxes));
    view.eye_world = camera.eye_world;
    if (camera.orthographic_height_m) {
        view.to_viewer_world = camera.eye_world - camera.target_world;
        if (view.to_viewer_world == glm::dvec3(0.0)) view.to_viewer_world = -direction;
    }
    view.size_px = size_px;
    view.px_scale = px_scale;
    return view;
}

bool is_beyond(const View& view, const Box& box_world)
{
    if (!view.is_orthographic()) return false;
    // About the eye: far from the origin the view's own translation is coarse.
    const Box relative{box_world.min - view.eye_world, box_world.max - view.eye_world};
    const Box clip =
        transformed(relative, glm::dmat4(view.clip_from_view) * glm::dmat4(glm::dmat3(view.view_from_world)));
    return clip.max.z > 1.0 && clip.overlaps({{-1.0, -1.0, -1.0}, {1.0, 1.0, clip.max.z}});
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
