#pragma once

#include "hatchway/io/meshes/checked_mesh.hpp"

namespace hw {

/// PLY as text or binary of either byte order. Throws hw::Error with the place for what is no file of that format,
/// breaks a limit, or refers to what does not exist. `name` stands in messages.
CheckedMesh check_ply(std::string bytes, const std::string& name);

}  // namespace hw
