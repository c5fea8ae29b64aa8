#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hatchway/geometry/surface/outline_order.hpp"
#include "hatchway/geometry/surface/rounded_planes.hpp"

namespace hw {

struct Surface;
struct PlacedEdge;

/// The edges of two faces in clusters, each with all that its edges need: 32 faces of consecutive numbers, the edges
/// among them and some of those to neighbours (each edge belongs to one cluster), and the planes of all these faces in
/// one place of memory, so that far fewer pages are touched. Around the planes there is a box: where it is certain of
/// the viewer's side no edge of the cluster is a silhouette, and nothing else of it is looked at. The same again around
/// groups of 16 clusters, so that far from the contour not even boxes are looked at. About 16 bytes an edge.
class FaceClusters {
 public:
    static constexpr std::uint32_t kFaces = kClusterFaces;
    static constexpr std::uint32_t kMostNeighbours = 3 * kFaces;  ///< A face has three sides.

    /// An edge's face within its cluster: below kFaces a face of the cluster, from there on a neighbour.
    using Place = std::uint8_t;

    struct Cluster {
        const StepBlocks::Block* planes;  ///< Of its faces, room for 32; then of its neighbours.
        std::uint32_t neighbour_count;
        std::uint32_t edge_count;
        const Place* places;  ///< Of the edges' faces A, then of their faces B. 64 can be read from each place on.
        const std::uint32_t* edges;  ///< Into the edge table, rising.
    };

    /// Takes the edges of two faces and the planes of a surface whose faces stand in outline order.
    void prepare(const Surface& surface);

    bool is_empty() const { return count_ == 0; }
    std::uint32_t count() const { return count_; }
    std::uint32_t group_count() const { return (count_ + kGroupClusters - 1) / kGroupClusters; }
    Cluster cluster(std::uint32_t number) const;
    /// Edges at faces turned over: to be looked at one by one.
    std::span<const std::uint32_t> loose_edges() const { return loose_edges_; }
    std::size_t bytes() const;

    /// Lists the clusters that are not certain into `mixed`, which has room for all, and returns their number. `bits`
    /// hold a word for each 32 groups.
    std::uint32_t find_mixed(const EyeSteps& eye, const SideBits& bits, std::span<std::uint32_t> mixed) const;

 private:
    using Block = StepBlocks::Block;

    /// Where a cluster lies in memory_: blocks of planes, then of places, then of edges.
    struct Record {
        std::uint32_t first_block;
        std::uint16_t neighbour_count;
        std::uint16_t edge_count;
    };

    /// Gives the planes of the cluster's faces and neighbours.
    std::vector<RoundedPlane> add_cluster(const Surface& surface, std::span<const PlacedEdge> edges);

    std::uint32_t count_ = 0;
    std::vector<Record> records_;
    std::vector<Block> memory_;
    std::vector<std::uint32_t> loose_edges_;
    PlaneBoxes cluster_boxes_;
    PlaneBoxes group_boxes_;
};

}  // namespace hw
