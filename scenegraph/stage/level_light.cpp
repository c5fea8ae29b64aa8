#include "hatchway/stage/level_light.hpp"

#include <cmath>

#include "hatchway/render/view/frame_block.hpp"

namespace hw {

LightSources light_sources_of(const Level& level, const Scene& scene)
{
    LightSources sources;
    sources.lights = lights_of(level, scene);
    const auto exposure_ev = static_cast<float>(exposure_ev_of(level, scene, sources.lights));
    const AmbientLight ambient = ambient_light(exposure_ev, !sources.lights.empty());
    sources.sky_luminance = ambient.sky_luminance;
    sources.ground_luminance = ambient.ground_luminance;
    sources.emission_luminance = white_luminance(exposure_ev);
    return sources;
}

}  // namespace hw
