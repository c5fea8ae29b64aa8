#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "hatchway/geometry/surface/edge_table.hpp"
#include "hatchway/geometry/surface/face_clusters.hpp"
#include "hatchway/geometry/surface/facing_filter.hpp"

namespace hw {

// The inner loops of the hierarchy. Nobody else needs them.

/// A bit for each face of a cluster, then for its neighbours.
struct ClusterFacing {
    static constexpr std::size_t kBatch = 32;  ///< Clusters looked into together: their bits stay in the first cache.
    static constexpr std::size_t kWords = 1 + FaceClusters::kMostNeighbours / 32;
    std::array<std::uint32_t, kWords> front;
    std::array<std::uint32_t, kWords> open;  ///< Not decided; bits past the last neighbour are zero.
};
static_assert(FaceClusters::kFaces == 32, "the first word has a bit for each of the cluster's own faces");

/// Decides the planes of the first facing.size() clusters that `mixed` names; the others are those asked for next.
void decide_clusters(const FacingFilter& filter, const FaceClusters& clusters, const EyeSteps& eye,
                     std::span<const std::uint32_t> mixed, std::span<ClusterFacing> facing);

/// The edges that are asked for.
struct WantedEdges {
    EdgeRange first, second;

    bool has(std::uint32_t edge) const
    {
        return static_cast<std::uint32_t>(edge - first.begin < first.size()) |
               static_cast<std::uint32_t>(edge - second.begin < second.size());
    }
};

/// Writes the wanted edges of facing.size() clusters, kBatch at most, whose faces differ in `front` to `found` and
/// returns their number. `found` has room for one more than all wanted edges.
std::uint32_t list_differing(const FaceClusters& clusters, std::span<const std::uint32_t> mixed,
                             std::span<const ClusterFacing> facing, const WantedEdges& wanted, std::uint32_t* found);

}  // namespace hw
