#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hatchway/geometry/surface/directed_edges.hpp"

namespace hw {

/// Faces connected over edges of exactly two faces.
struct WindingRepair {
    std::vector<std::uint32_t> face_component;
    std::uint32_t component_count = 0;
    std::uint32_t flipped_faces = 0;
};

/// Flips the minority of faces in every component whose winding is inconsistent. A consistent component is left as it
/// is, also when it faces inward: that is a room. A component that cannot be oriented keeps its winding unless flipping
/// leaves fewer inconsistent edges. Of two equal halves the one without the component's first face is flipped.
WindingRepair repair_winding(std::vector<FaceCorners>& faces, std::span<const DirectedEdge> uses);

}  // namespace hw
