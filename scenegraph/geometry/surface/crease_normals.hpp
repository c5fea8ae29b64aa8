#pragma once

#include "hatchway/geometry/mesh_data.hpp"

namespace hw {

/// Gives a mesh without normals smooth ones with creases: a vertex takes the mean of its faces' normals, weighted by
/// area, as long as all lie within `crease_rad` of that mean; else its faces are parted into groups that lie within
/// `crease_rad` of the first of the group, and each further group gets a copy of the vertex at the end of the streams.
/// Faces without area count for nothing and take what their vertices have; zero where there is nothing else.
void add_crease_normals(MeshData& mesh, float crease_rad);

}  // namespace hw
