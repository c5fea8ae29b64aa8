#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hatchway/geometry/mesh_chunks.hpp"
#include "hatchway/world/scene.hpp"
#include "hatchway/world/visibility/rows/pvs.hpp"
#include "hatchway/world/visibility/tree/bsp.hpp"

namespace hw {

/// A chunk of an object: what is switched on and off.
struct ChunkSlot {
    ObjectId object = 0;
    std::uint32_t chunk = 0;  ///< Into the MeshChunks of the object's mesh.
};

/// What the slots are and where eyes can be.
struct SlotPlaces {
    const Scene& scene;
    std::span<const MeshChunks> chunks_of_mesh;
    std::span<const ChunkSlot> slots;
    const BspTree& tree;
    std::span<const Box> cluster_boxes;  ///< World space.
};

/// The slots that each cluster may see: those with a triangle in an open leaf of a cluster that it sees, drawn from a
/// side on which a part of the seeing cluster lies (the top of a wall is not seen from below). Animated objects are
/// seen by all.
LeafRows slots_seen(const SlotPlaces& places, const LeafRows& clusters_seen);

}  // namespace hw
