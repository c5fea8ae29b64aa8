#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "hatchway/world/level.hpp"
#include "hatchway/world/scene.hpp"
#include "hatchway/world/visibility/tree/bsp.hpp"

namespace hw {

/// What becomes structure where the level does not say.
struct StructureOptions {
    int max_structure = 6000;
    int max_details = 6000;
    std::size_t max_triangles = 300'000;  ///< Of more, those in small planes are passed over: see large_planes.hpp.
    double least_area_share = 1.5e-2;     ///< All that lies in one plane, of the largest side of the scene's box.
    double margin_m = 0.0;  ///< By which the box is larger than the scene, so that outer walls count, too.
};

/// The polygons that partition space and block sight, snapped to the grid.
struct Structure {
    Grid grid;
    PlaneSet planes;
    std::vector<BlockingPolygon> polygons;  ///< By the area in their plane, largest first: structure, then details.
    int structure_count = 0;
    std::size_t left_out = 0;               ///< Polygons and triangles over the budget: they do not block.
    std::vector<glm::dvec3> demoted_world;  ///< Where polygons in large planes are details, for want of budget.
    std::array<std::int64_t, 3> box_min{};  ///< The scene's box; what lies in its faces is left out.
    std::array<std::int64_t, 3> box_max{};
    double scene_side_m2 = 0.0;  ///< Area of the largest side of the scene's box.
    double area_m2 = 0.0;        ///< Of all polygons.
};

/// For every node, whether Level::structure names it or one of its parents. Throws hw::Error for a name that reaches no
/// node.
std::vector<char> structure_nodes(const Scene& scene, const Level& level);

/// Chooses and merges the structure of a scene from its opaque, static triangles. Structure is what lies in large
/// planes, of the objects that Level::structure names (its globs reach children too), or of all; everything else is
/// detail. Where nothing is structure there are no details either. Triangles within 1e-5 m (a step and a quarter of the
/// finest grid) of a larger one's plane are laid into it, so that planes which the model means to be one are one.
/// Triangles in one plane that are drawn from the same sides are merged across a shared edge while their union is
/// exactly convex; nothing is ever added to what is drawn. Deterministic. Throws hw::Error if a name of
/// Level::structure reaches no node.
Structure choose_structure(const Scene& scene, const Level& level, const StructureOptions& options);

}  // namespace hw
