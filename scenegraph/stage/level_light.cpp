#include "hatchway/stage/level_light.hpp"

#include <cmath>

#include "hatchway/render/view/frame_block.hpp"

namespace hw {

namespace {

/// Where the level itself looks from. A walker may go where no camera of the level is; what is closed there stays a
/// solid.
std::vector<glm::dvec3> eyes_of(const Level& level, const Scene& scene)
{
    std::vector<glm::dvec3> eyes;
    if (level.start) eyes.push_back(level.start->position);
    for (const std::vector<Camera>* cameras : {&level.cameras, &scene.cameras})
        for (const Camera& camera : *cameras) eyes.push_back(camera.eye_world);
    for (const CameraPath& path : level.paths)
        for (const PathKey& key : path.keys) eyes.push_back(key.position);
    return eyes;
}

}  // namespace

LightSources light_sources_of(const Level& level, const Scene& scene)
{
    LightSources sources;
    sources.lights = lights_of(level, scene);
    const auto exposure_ev = static_cast<float>(exposure_ev_of(level, scene, sources.lights));
    const AmbientLight ambient = ambient_light(exposure_ev, !sources.lights.empty());
    sources.sky_luminance = ambient.sky_luminance;
    sources.ground_luminance = ambient.ground_luminance;
    sources.emission_luminance = white_luminance(exposure_ev);
    sources.eyes_world = eyes_of(level, scene);
    return sources;
}

}  // namespace hw
