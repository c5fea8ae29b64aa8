#pragma once

#include <vector>

#include "hatchway/geometry/mesh_data.hpp"
#include "hatchway/io/meshes/raw_mesh.hpp"

namespace hw {

/// The meshes of the parts of a file, one for each, empty for a part without faces: polygons become triangles, vertices
/// that no face uses are gone, those that faces use with different attributes are there several times. Colours become
/// linear, v runs downwards as everywhere in the engine. A part of which each corner has a normal keeps them; any other
/// gets smooth ones that break at creases.
std::vector<MeshData> build_meshes(const RawMesh& raw, const CheckedMesh& checked);

}  // namespace hw
