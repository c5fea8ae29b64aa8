#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "hatchway/geometry/topology/directed_edges.hpp"
#include "hatchway/geometry/topology/weld.hpp"

namespace hw {

/// A welded mesh whose faces fit together as well as they can be made to. Every topology is taken.
struct RepairedMesh {
    std::vector<glm::vec3> positions;            ///< No two are equal.
    std::vector<std::uint32_t> vertex_position;  ///< As WeldedMesh has it.
    std::vector<FaceCorners> faces;              ///< Of the welded faces those that stay, in their order; then caps.
    std::vector<std::uint32_t> face_triangle;    ///< Where each came from; kNoFace for caps (close_t_junctions()).
    std::vector<bool> two_sided_faces;           ///< Modelled from both sides; empty: none.
    std::vector<DirectedEdge> uses;
    std::vector<std::uint32_t> face_component;  ///< Connected over edges of exactly two faces.
    std::uint32_t component_count = 0;

    std::vector<std::uint32_t> doubled_triangles;  ///< Left out: find_doubled_faces(), find_doubled_patches().
    std::uint32_t stitched_edges = 0;              ///< Pairs of borders that became one edge.
    std::uint32_t pinholes = 0;                    ///< Holes that became a point.
    std::uint32_t t_junction_edges = 0;            ///< Borders that got caps.
    std::vector<std::uint32_t> flipped_faces;      ///< Turned over, and not two-sided; rising.
};

/// In this order: joins doubled sheets, also such as are nearly doubled (join_near_doubles()), stitches borders closer
/// than `stitch_share` of the bounding box' diagonal, makes points of holes as small (close_pinholes()), closes
/// T-junctions as wide, repairs the winding.
RepairedMesh repair_mesh(WeldedMesh mesh, float stitch_share);

/// The share of the bounding box' diagonal within which borders are joined.
inline constexpr float kStitchShare = 1e-5f;

}  // namespace hw
