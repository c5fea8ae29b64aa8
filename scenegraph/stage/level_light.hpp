#pragma once

#include "hatchway/stage/level_world.hpp"
#include "hatchway/world/light/transport.hpp"

namespace hw {

/// What shines on a level: its lights, the sky and the ground as the frame's light from everywhere has them, and
/// emissive materials as bright as the exposure shows them; its eyes are the start, all cameras and the keys of paths.
LightSources light_sources_of(const Level& level, const Scene& scene);

}  // namespace hw
