#pragma once

#include "hatchway/io/meshes/checked_mesh.hpp"

namespace hw {

/// OBJ: positions with colours, texture coordinates, normals, polygons, groups and materials. Throws hw::Error with the
/// place for what is no file of that format, breaks a limit, or refers to what does not exist. `name` stands in
/// messages.
CheckedMesh check_obj(std::string bytes, const std::string& name);

}  // namespace hw
