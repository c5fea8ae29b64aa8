#pragma once

#include "hatchway/io/meshes/checked_mesh.hpp"

namespace hw {

/// OFF as text: also COFF, NOFF, CNOFF, and colours behind faces. Throws hw::Error with the place for what is no file
/// of that format, breaks a limit, or refers to what does not exist. `name` stands in messages.
CheckedMesh check_off(std::string bytes, const std::string& name);

}  // namespace hw
