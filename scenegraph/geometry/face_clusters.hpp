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

/// Faces in clusters of 32 consecutive numbers, each with a cone around its normals and a slab around its planes: most
/// clusters look at the viewer, or away, as a whole, and then none of their faces and inner edges need be looked at.
/// The same again with groups of 32 clusters, so that far from the contour not even clusters are looked at. 6 bytes an
/// edge and about 3 bytes a face.
class FaceClusters {
 public:
    static constexpr std::uint32_t kFaces = 32;
    static constexpr std::uint32_t kGroup = 16;  ///< Clusters in a group.

    enum class Facing : std::uint8_t { back, front, mixed };

    /// Edges between two clusters, or inside of one: `edges()` from `begin` to the next link's begin.
    struct Link {
        std::array<std::uint32_t, 2> clusters;
        std::uint32_t begin;
    };

    /// Takes the edges of two faces and the planes of a surface whose faces stand in spatial order.
    void prepare(const Surface& surface);

    bool is_empty() const { return count_ == 0; }
    std::uint32_t count() const { return count_; }
    std::uint32_t group_count() const { return (count_ + kGroup - 1) / kGroup; }
    std::size_t bytes() const;

    /// Decides all groups and clusters: `front` and `back` are proven for all faces, `mixed` is the rest. A cluster
    /// that is decided gets a mask of 32 equal bits, 1 for front; those that are not are appended to `mixed` from 0 on,
    /// and their number is returned. `groups`, `masks` and `mixed` have room for all.
    std::uint32_t decide(const Viewpoint& viewpoint_object, std::span<Facing> groups, std::span<std::uint32_t> masks,
                         std::span<std::uint32_t> mixed) const;

    /// The links from clusters of a group to clusters of the same or a higher number: places in `links()`.
    std::array<std::uint32_t, 2> group_link_range(std::uint32_t group) const
    {
        return {first_link_[group], first_link_[group + 1]};
    }
    /// One more than there are, for the end of the last.
    std::span<const Link> links() const { return links_; }
    /// The groups of higher number that links of a group's clusters lead to.
    std::span<const std::uint32_t> group_links(std::uint32_t group) const
    {
        return {group_links_.data() + first_group_link_[group], group_links_.data() + first_group_link_[group + 1]};
    }
    std::span<const std::uint32_t> edges() const { return edges_; }
    /// For each of them its face in the cluster and its face in the link's other cluster, counted from their first:
    /// small enough to stream through, where the edge table would have to be looked up here and there. Eight more than
    /// there are edges, so that eight can be read at a time.
    std::span<const std::array<std::uint8_t, 2>> edge_faces() const { return edge_faces_; }
    /// Edges at faces turned over: to be looked at one by one.
    std::span<const std::uint32_t> loose_edges() const { return loose_edges_; }

 private:
    /// For runs of faces, relative to centre_ and scale_: centre (x y z), its farthest distance from a face's plane,
    /// and a cone around the normals (axis times the cosine, squared sine).
    using Bounds = std::array<std::vector<float>, 8>;

    struct Query;
    void bound_faces(const Surface& surface, std::uint32_t faces_each, Bounds& bounds) const;
    void sort_edges(const Surface& surface);
    void link_groups();
    static void decide_run(const Bounds& bounds, const Query& query, std::uint32_t begin, std::uint32_t end,
                           Facing* facing);

    std::uint32_t count_ = 0;
    glm::dvec3 centre_{0.0};
    double scale_ = 1.0;
    Bounds cluster_bounds_;
    Bounds group_bounds_;
    std::vector<std::uint32_t> edges_;
    std::vector<std::array<std::uint8_t, 2>> edge_faces_;
    std::vector<Link> links_;
    std::vector<std::uint32_t> first_link_;  ///< Of each group.
    std::vector<std::uint32_t> group_links_;
    std::vector<std::uint32_t> first_group_link_;
    std::vector<std::uint32_t> loose_edges_;
};

}  // namespace hw
