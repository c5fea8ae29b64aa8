#pragma once

#include <cstdint>
#include <vector>

#include "hatchway/geometry/mesh_data.hpp"

namespace hw {

/// What is wrong with the triangles of a mesh, to be mended before anything draws, culls, lights or collides by them.
/// Lists of triangles, rising.
struct MeshFaults {
    /// Wound against the rest of their component. In a component that is open, one whose own normals look where its
    /// winding does is none: levels are full of walls that meet back to front.
    std::vector<std::uint32_t> wrongly_wound;
    /// Those of open components that, once these are turned over, look down on the whole (or against x or z, where they
    /// stand). Of sheets that are seen from both sides the winding says nothing, and turned over all wind the same way.
    /// Without faces that are modelled from both sides.
    std::vector<std::uint32_t> of_turned_sheets;
    /// Have the corners of another triangle, whichever way they wind: where both sides are seen anyway, one of the two
    /// would show through the other at random.
    std::vector<std::uint32_t> doubled;
};
MeshFaults find_mesh_faults(const MeshData& mesh);

/// Turns triangles over. A normal of a vertex that only they use is turned too where it looks to their back.
void turn_over(MeshData& mesh, const std::vector<std::uint32_t>& triangles);

/// Leaves triangles out. Vertices stay.
void leave_out(MeshData& mesh, const std::vector<std::uint32_t>& triangles);

}  // namespace hw
