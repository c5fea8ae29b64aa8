#pragma once

#include "hatchway/io/gltf/nodes.hpp"

namespace hw {

/// Adds the lights and cameras that hang on the scene's nodes.
void add_lights(const GltfModel& model, const NodeOrder& order, Scene& scene);
void add_cameras(const GltfModel& model, const NodeOrder& order, Scene& scene);

}  // namespace hw
