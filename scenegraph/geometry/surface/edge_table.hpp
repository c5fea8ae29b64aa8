#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "hatchway/geometry/topology/directed_edges.hpp"

namespace hw {

/// What an edge can add to a line drawing, decided before any view is known. In all groups but the first, edges stand
/// by falling fold, so that the creases of any crease angle are the beginnings of these groups.
enum class EdgeGroup : std::uint8_t {
    border,         ///< One face, or more than two: drawn from every viewpoint.
    artist_convex,  ///< Two faces, marked by the artist or by split normals: drawn from every viewpoint.
    artist_reflex,  ///< The same, reflex or flat.
    convex,         ///< Two faces, strictly convex: a ridge, or a contour candidate when smooth.
    reflex,         ///< Two faces, reflex, no right to the reflex rule: a valley, or a contour candidate when smooth.
    reflex_silent,  ///< Reflex with that right, or flat: a valley, or never drawn when smooth.
};
inline constexpr int kEdgeGroupCount = 6;

/// A run of edge ids.
struct EdgeRange {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::uint32_t size() const { return end - begin; }
};

/// An edge, told by where it is a side of its face A: its ends are then known from the face (edge_vertices()). 8 bytes.
struct Edge {
    std::uint32_t side_a;  ///< Four times the number of face A, and the corner of A at which the edge begins.
    /// Face B. kNoFace at a border of one face; complex edges name the second of their faces. Where the surface cannot
    /// be oriented, B is a reversed twin of the face (an index past Surface::faces, see FacingFilter).
    std::uint32_t face_b;

    static std::uint32_t side(std::uint32_t face, std::uint32_t corner) { return 4 * face + corner; }
    std::uint32_t face_a() const { return side_a / 4; }
    std::uint32_t corner_a() const { return side_a % 4; }
    std::array<std::uint32_t, 2> faces() const { return {face_a(), face_b}; }
    bool operator==(const Edge&) const = default;
};

/// A face at a complex edge that Edge does not name.
struct MoreFace {
    std::uint32_t edge;
    std::uint32_t face;
};

/// All edges of a surface. An edge id is a place in this table.
struct EdgeTable {
    std::vector<Edge> edges;
    std::vector<MoreFace> more_faces;                              ///< By edge.
    std::array<std::uint32_t, kEdgeGroupCount + 1> group_begin{};  ///< group_begin[g] .. group_begin[g + 1]

    std::uint32_t size() const { return static_cast<std::uint32_t>(edges.size()); }
    EdgeRange group(EdgeGroup group) const
    {
        const auto index = static_cast<std::size_t>(group);
        return {group_begin[index], group_begin[index + 1]};
    }
    /// Edges of exactly two faces.
    EdgeRange two_faced() const { return {group_begin[1], size()}; }
    const Edge& operator[](std::uint32_t edge) const { return edges[edge]; }
    /// Beside the two that the edge names: none but at complex edges.
    std::span<const MoreFace> more_faces_at(std::uint32_t edge) const;
};

struct Surface;

/// The table cut at one crease angle. Ranges of ids, nothing is copied.
struct EdgeClasses {
    EdgeRange borders;
    std::array<EdgeRange, 2> ridges;      ///< Convex creases, the artist's among them.
    std::array<EdgeRange, 3> valleys;     ///< Reflex creases, the artist's among them.
    std::array<EdgeRange, 2> artist;      ///< The artist's edges that are no creases by their fold.
    std::array<EdgeRange, 2> candidates;  ///< Contours where one face looks at the eye and the other does not.
    EdgeRange silent;                     ///< Never drawn.

    /// Drawn from every viewpoint beside borders: ridges, valleys and artist's edges.
    std::uint32_t crease_count() const
    {
        return ridges[0].size() + ridges[1].size() + valleys[0].size() + valleys[1].size() + valleys[2].size() +
               artist[0].size() + artist[1].size();
    }
    std::uint32_t candidate_count() const { return candidates[0].size() + candidates[1].size(); }
};

/// Cuts the table: a crease is an edge folded by more than `crease_rad` (0 is flat; pi or more: no creases). An edge at
/// the angle itself, within a millionth of a radian, is no crease. A few fold computations, no memory.
EdgeClasses classes_at(const Surface& surface, float crease_rad);

/// The angle between the normals of the two faces of an edge, in [0, pi]; 0 where a face has no plane or is missing.
float fold_rad(const Surface& surface, std::uint32_t edge);
float fold_rad(const Surface& surface, std::uint32_t face_a, std::uint32_t face_b);

/// The ends of an edge, into Surface::positions, in the direction of face A.
std::array<std::uint32_t, 2> edge_vertices(const Surface& surface, std::uint32_t edge);

}  // namespace hw
