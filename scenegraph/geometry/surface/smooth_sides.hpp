#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "hatchway/geometry/topology/weld.hpp"

namespace hw {

/// No side beyond.
inline constexpr std::uint32_t kNoSide = 0xffffffffu;

/// The faces of a welded mesh and how they go on over their sides. Side 3 f + c runs from corner c of face f to the
/// next.
struct SmoothSides {
    std::vector<std::uint32_t> twin;  ///< The same edge of the next face; kNoSide at borders and complex edges.
    std::vector<bool> is_crease;      ///< Of each side with a twin: folded by more than the angle.
    std::vector<glm::vec3> normals;   ///< Unit, of each face; zero where it has no plane.
    std::vector<float> areas;
    std::uint32_t crease_edges = 0;

    bool is_smooth(std::uint32_t side) const { return twin[side] != kNoSide && !is_crease[side]; }
};

SmoothSides find_smooth_sides(const WeldedMesh& mesh, float crease_rad);

/// Corners of one vertex that are joined over sides which `is_joined`: one number for each corner, 0 to count - 1.
struct CornerGroups {
    std::vector<std::uint32_t> group;  ///< Of each corner 3 f + c.
    std::uint32_t count = 0;
};
CornerGroups join_corners(const SmoothSides& sides, const std::vector<bool>& is_joined);

}  // namespace hw
