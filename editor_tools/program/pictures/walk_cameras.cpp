#include "program/pictures/walk_cameras.hpp"

#include <fmt/format.h>

#include "hatchway/core/error.hpp"
#include "hatchway/stage/whole_scene.hpp"

namespace hw {

std::vector<Camera> walk_cameras(const Level& level, const Scene& scene)
{
    std::vector<Camera> cameras = level.cameras;
    cameras.insert(cameras.end(), scene.cameras.begin(), scene.cameras.end());
    return cameras;
}

Camera camera_named(const std::string& name, const Level& level, const Scene& scene, const std::string& instead)
{
    const std::vector<Camera> cameras = walk_cameras(level, scene);
    std::vector<std::string> names;
    for (const Camera& camera : cameras) {
        if (camera.name == name) return camera;
        names.push_back(camera.name);
    }
    throw Error({.what = fmt::format("--camera: there is no camera \"{}\"", name),
                 .file = level.file.string(),
                 .expected = names.empty() ? instead : fmt::format("one of: {}", fmt::join(names, ", "))});
}

Camera start_camera(const Level& level, const Scene& scene, double aspect)
{
    if (level.start) return {.name = "start", .eye_world = level.start->position, .target_world = level.start->look_at};
    const CameraPlace place = whole_scene_camera(scene, aspect);
    return {
        .name = "overview", .eye_world = place.eye_world, .target_world = place.target_world, .fov_deg = place.fov_deg};
}

std::string camera_arguments(const Camera& camera)
{
    const auto text = [](const glm::dvec3& p) { return fmt::format("{:.4f},{:.4f},{:.4f}", p.x, p.y, p.z); };
    const std::string projection = camera.orthographic_height_m
                                       ? fmt::format("--ortho {:.6g}", *camera.orthographic_height_m)
                                       : fmt::format("--fov-deg {:.4g}", camera.fov_deg);
    const std::string roll = camera.roll_deg == 0.0 ? "" : fmt::format(" --roll-deg {:.4g}", camera.roll_deg);
    return fmt::format("--eye {} --target {} {}{}", text(camera.eye_world), text(camera.target_world), projection,
                       roll);
}

}  // namespace hw
