#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "hatchway/geometry/mesh_data.hpp"

namespace hw {

/// Where the coordinates that strokes follow come from.
enum class HatchSource : std::uint8_t {
    model,      ///< The model's texture coordinates; box where it has none.
    box,        ///< Seen straight along the nearest axis: walls, floors, furniture.
    cylinder,   ///< Around the upright axis, or the longest one: columns, trunks, pots.
    principal,  ///< Along the direction of strongest curvature: strokes go round the form.
};

/// What making coordinates found. Edges of exactly two faces count once.
struct HatchReport {
    std::uint32_t charts = 0;              ///< Pieces over which coordinates are continuous.
    std::uint32_t crease_edges = 0;        ///< Coordinates may break here: the surface does, too.
    std::uint32_t chart_border_edges = 0;  ///< Coordinates break here although the surface is smooth.
    std::uint32_t singularities = 0;       ///< Vertices around which no direction is continuous.
};

/// Hatch coordinates of a mesh. Vertices of the mesh stand once for each chart that they are in.
struct HatchCoordinates {
    std::vector<std::uint32_t> vertex;  ///< Into the MeshData's streams, for each vertex here.
    std::vector<glm::vec2> uv;  ///< About metres, object space; seen from outside u turned left by 90 degrees is v.
    std::vector<glm::vec3> direction;    ///< Unit, object space, along the surface: where u rises.
    std::vector<std::uint32_t> indices;  ///< Three per triangle, triangles in the order of the MeshData.
    HatchReport report;
};

/// Makes coordinates that are continuous over smooth surface and break only at creases (folded by more than
/// `crease_rad`), borders of charts and singular points, all counted. Takes every valid MeshData. `model` gives box.
/// The same mesh gives the same coordinates. Principal directions: Rusinkiewicz, Estimating Curvatures and Their
/// Derivatives on Triangle Meshes, 3DPVT 2004; smoothed as in Hertzmann, Zorin, Illustrating Smooth Surfaces, SIGGRAPH
/// 2000, section 5; laid out by least squares along them as in Bommes, Zimmer, Kobbelt, Mixed-Integer Quadrangulation,
/// SIGGRAPH 2009, without rounding.
HatchCoordinates make_hatch_coordinates(const MeshData& mesh, HatchSource source, float crease_rad = 0.7f);

}  // namespace hw
