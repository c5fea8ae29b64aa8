#pragma once

#include <cstdint>

#include "hatchway/geometry/mesh_data.hpp"

namespace hw {

/// A closed smooth surface with bumps, a sphere of radius 1 +- 0.1, from about `triangles` triangles: the same shape at
/// every size, to see how a cost grows.
MeshData smooth_mesh(std::uint32_t triangles);

}  // namespace hw
