#pragma once

#include <vector>

#include "hatchway/geometry/surface/surface.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// The adjacency of every mesh of the scene, by the rules that the renderer builds it by: a mesh is solid when its
/// material is opaque and single-sided, whatever `options` say about that.
std::vector<Surface> scene_surfaces(const Scene& scene, const SurfaceOptions& options = {});

}  // namespace hw
