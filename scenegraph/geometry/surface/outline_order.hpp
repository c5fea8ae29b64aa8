#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace hw {

/// Faces with consecutive numbers make one cluster, and so many clusters one group (FaceClusters).
inline constexpr std::uint32_t kClusterFaces = 32;
inline constexpr std::uint32_t kGroupClusters = 16;

/// The order in which faces that lie close together and face the same way have close numbers: halves along the axis,
/// of normals and centres, that varies most, cut where clusters and groups end. It follows from the faces alone.
/// Source: Hertzmann, Zorin. Illustrating Smooth Surfaces. SIGGRAPH 2000 (contours are found in the dual space of
/// planes); Johnson, Cohen. Spatialized Normal Cone Hierarchies. I3D 2001 (places and normals together).
std::vector<std::uint32_t> outline_order(std::span<const glm::vec3> positions,
                                         std::span<const std::array<std::uint32_t, 3>> faces);

}  // namespace hw
