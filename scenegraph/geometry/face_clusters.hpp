#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "geometry/viewpoint.hpp"

namespace hw {

struct Surface;

/// The order in which faces that lie close together have close numbers (Morton order of their centres).
std::vector<std::uint32_t> spatial_order(std::span<const glm::vec3> positions,
                                         std::span<const std::array<std::uint32_t, 3>> faces);

/// Faces in clusters of 32 consecutive numbers, each with a ball around it and a cone around its normals: most clusters
/// look at the viewer, or away, as a whole, and then none of their faces and inner edges need be looked at. The same
/// again with groups of 32 clusters, so that far from the contour not even clusters are looked at. 6 bytes an edge and
/// about 3 bytes a face.
class FaceClusters {
 public:
    static constexpr std::uint32_t kFaces = 32;
    static constexpr std::uint32_t kGroup = 32;  ///< Clusters in a group.

    enum class Facing : std::uint8_t { back, front, mixed };

    /// Edges between two clusters, or inside of one: a run of `edges()`.
    struct Link {
        std::uint32_t other;
        std::uint32_t begin;
        std::uint32_t end;
    };

    /// Takes the edges of two faces and the planes of a surface whose faces stand in spatial order.
    void prepare(const Surface& surface);

    bool is_empty() const { return count_ == 0; }
    std::uint32_t count() const { return count_; }
    std::uint32_t group_count() const { return (count_ + kGroup - 1) / kGroup; }
    std::size_t bytes() const;

    /// Decides all groups and clusters: `front` and `back` are proven for all faces, `mixed` is the rest.
    void decide(const Viewpoint& viewpoint_object, std::span<Facing> groups, std::span<Facing> clusters) const;

    /// The runs of edges that begin at a cluster: those inside of it first, then those to clusters of higher number.
    std::span<const Link> links(std::uint32_t cluster) const
    {
        return {links_.data() + first_link_[cluster], links_.data() + first_link_[cluster + 1]};
    }
    /// The groups of higher number that links of a group's clusters lead to.
    std::span<const std::uint32_t> group_links(std::uint32_t group) const
    {
        return {group_links_.data() + first_group_link_[group], group_links_.data() + first_group_link_[group + 1]};
    }
    std::span<const std::uint32_t> edges() const { return edges_; }
    /// For each of them its face in the cluster and its face in the link's other cluster, counted from their first:
    /// small enough to stream through, where the edge table would have to be looked up here and there.
    std::span<const std::array<std::uint8_t, 2>> edge_faces() const { return edge_faces_; }
    /// Edges at faces turned over: to be looked at one by one.
    std::span<const std::uint32_t> loose_edges() const { return loose_edges_; }

 private:
    /// Balls (x y z r) around and cones (x y z sine) for runs of faces, relative to centre_ and scale_.
    using Bounds = std::array<std::vector<float>, 8>;

    struct Query;
    void bound_faces(const Surface& surface, std::uint32_t faces_each, Bounds& bounds) const;
    void sort_edges(const Surface& surface);
    void link_groups();
    static void decide_run(const Bounds& bounds, const Query& query, std::uint32_t begin, std::uint32_t end,
                           std::span<Facing> facing);

    std::uint32_t count_ = 0;
    glm::dvec3 centre_{0.0};
    double scale_ = 1.0;
    Bounds cluster_bounds_;
    Bounds group_bounds_;
    std::vector<std::uint32_t> edges_;
    std::vector<std::array<std::uint8_t, 2>> edge_faces_;
    std::vector<Link> links_;
    std::vector<std::uint32_t> first_link_;
    std::vector<std::uint32_t> group_links_;
    std::vector<std::uint32_t> first_group_link_;
    std::vector<std::uint32_t> loose_edges_;
};

}  // namespace hw
