#include "program/pictures/walk_cameras.hpp"

#include <fmt/format.h>

#include "hatchway/core/error.hpp"

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

}  // namespace hw
