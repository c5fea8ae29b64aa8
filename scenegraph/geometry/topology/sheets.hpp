#pragma once

#include <cstdint>
#include <vector>

#include "hatchway/geometry/mesh_data.hpp"

namespace hw {

/// The triangles of those open components of a mesh that, on the whole, look down (or against x or z, where they
/// stand): rising. Of sheets that are seen from both sides the winding says nothing, and turned over by this all wind
/// the same way. Faces that are modelled from both sides are left alone.
std::vector<std::uint32_t> triangles_of_turned_sheets(const MeshData& mesh);

}  // namespace hw
