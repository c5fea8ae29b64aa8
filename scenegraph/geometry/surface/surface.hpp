#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <vector>

#include "hatchway/geometry/mesh_data.hpp"
#include "hatchway/geometry/surface/edge_table.hpp"
#include "hatchway/geometry/surface/face_clusters.hpp"
#include "hatchway/geometry/surface/facing_filter.hpp"
#include "hatchway/geometry/topology/repaired_mesh.hpp"

namespace hw {

/// What the owner of a mesh knows about its use.
struct SurfaceOptions {
    /// Opaque, single-sided, and no camera gets inside: closed outward components then may use the reflex rule.
    bool is_solid = true;
    /// The linear part of what places the mesh in the world: folds are angles there. Object space where it flattens.
    glm::dmat3 world_from_object{1.0};
    /// Borders closer than this share of the bounding box' diagonal are joined.
    float stitch_share = kStitchShare;
    /// Where the model's own normals split over a smaller fold than this, nobody meant an edge.
    float artist_fold_rad = 0.035f;
    /// From so many faces on the surface gets clusters for silhouettes. Measured: they pay from here on.
    std::uint32_t cluster_from_faces = 2'000;
};

/// What the making of a surface found and repaired, for `hatchway info`.
struct SurfaceReport {
    std::uint32_t triangles_in = 0;
    std::uint32_t removed_faces = 0;       ///< Two equal corners.
    std::uint32_t doubled_faces = 0;       ///< Repeat the corners of another face, whichever way they wind.
    std::uint32_t collinear_faces = 0;     ///< Kept in the topology, never drawn.
    std::uint32_t needle_faces = 0;        ///< So thin that their floats do not tell their plane.
    std::uint32_t flipped_faces = 0;       ///< The minority of an inconsistently wound component.
    std::uint32_t inconsistent_edges = 0;  ///< Left after the repair: the surface cannot be oriented (Moebius).
    std::uint32_t border_edges = 0;        ///< One face.
    std::uint32_t complex_edges = 0;       ///< More than two faces.
    std::uint32_t stitched_edges = 0;      ///< Pairs of borders that became one edge.
    std::uint32_t pinholes = 0;            ///< Holes so small that they became a point.
    std::uint32_t t_junction_edges = 0;    ///< Borders that are cut by the corners of others, joined to those.
    std::uint32_t artist_edges = 0;
    std::uint32_t components = 0;              ///< Connected over edges of exactly two faces.
    std::uint32_t closed_components = 0;       ///< Neither borders nor complex edges, consistently wound.
    std::uint32_t inward_components = 0;       ///< Closed and facing inward: rooms. Never flipped.
    std::uint32_t reflex_rule_components = 0;  ///< Have the right to leave reflex edges out.
};

/// A piece of the surface, connected over edges of exactly two faces.
struct SurfaceComponent {
    std::uint32_t face_count = 0;
    bool is_closed = false;        ///< No border, no complex edge, consistently wound.
    bool is_outward = false;       ///< Closed, and its signed volume is above zero.
    bool is_two_sided = false;     ///< Some of it was modelled from both sides.
    bool has_reflex_rule = false;  ///< Closed, outward, solid and not two-sided.
};

/// A mesh with its adjacency, in object space: what outlines are found on. Plain data, made once by build_surface().
struct Surface {
    std::vector<glm::vec3> positions;  ///< Welded; no two are equal.
    /// Into `positions`, winding repaired, collinear faces included. In outline order.
    std::vector<std::array<std::uint32_t, 3>> faces;
    /// The triangle of the MeshData that a face came from; kNoFace for caps, which join borders and are never drawn.
    std::vector<std::uint32_t> face_triangle;
    std::vector<bool> two_sided_faces;          ///< Modelled from both sides, so never culled; empty: none.
    std::vector<std::uint32_t> face_component;  ///< Into `components`.
    std::vector<SurfaceComponent> components;
    glm::dmat3 normal_from_object{1.0};  ///< Of normals in the world whose angles are folds; any length.
    EdgeTable edges;
    FacingFilter filter;
    FaceClusters clusters;  ///< Empty for surfaces so small that they would not pay.
    SurfaceReport report;

    bool is_two_sided(std::uint32_t face) const { return !two_sided_faces.empty() && two_sided_faces[face]; }
};

/// Welds by exact position, joins doubled faces, stitches borders, closes T-junctions, repairs the winding, classifies
/// edges. Takes every valid MeshData: no
/// topology is an error. The same mesh gives the same surface, bit by bit.
Surface build_surface(const MeshData& mesh, const SurfaceOptions& options = {});

/// Memory that the surface holds for outlines beside positions and faces.
struct OutlineBytes {
    std::size_t edges = 0;     ///< Of the edge table: all that an edge costs that is drawn from every viewpoint.
    std::size_t planes = 0;    ///< Rounded planes, a property of faces.
    std::size_t clusters = 0;  ///< Of the hierarchy; 0 where a surface has none.
};
OutlineBytes outline_bytes(const Surface& surface);

}  // namespace hw
