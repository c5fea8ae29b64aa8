#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "hatchway/geometry/topology/directed_edges.hpp"

namespace hw {

/// Faces connected over edges of exactly two faces.
struct WindingRepair {
    std::vector<std::uint32_t> face_component;
    std::uint32_t component_count = 0;
    std::vector<std::uint32_t> flipped_faces;  ///< Rising.
};

/// Flips the smaller area of faces in every component whose winding is inconsistent. A consistent component is left as
/// it is, also when it faces inward: that is a room. A component that cannot be oriented keeps its winding unless
/// flipping leaves fewer inconsistent edges. Of two equal halves that one is flipped that leaves a solid, if the
/// component is closed, else the one without its first face.
WindingRepair repair_winding(std::span<const glm::vec3> positions, std::vector<FaceCorners>& faces,
                             std::span<const DirectedEdge> uses);

}  // namespace hw
