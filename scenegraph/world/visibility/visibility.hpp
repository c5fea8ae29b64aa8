#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "hatchway/geometry/mesh_chunks.hpp"
#include "hatchway/world/level.hpp"
#include "hatchway/world/scene.hpp"
#include "hatchway/world/visibility/rows/pvs.hpp"
#include "hatchway/world/visibility/rows/shortfall.hpp"
#include "hatchway/world/visibility/rows/slot_rows.hpp"
#include "hatchway/world/visibility/tree/bsp.hpp"

namespace hw {

/// How the potentially visible set is made. Every choice is conservative.
struct VisibilityOptions {
    PvsEffort effort = PvsEffort::full;
    int max_structure_polygons = 15000;  ///< The largest planes win; what does not is detail.
    int max_detail_polygons = 30000;     ///< Details past this do not block.
    double least_area_share = 1.5e-2;    ///< Least area in one plane, of the largest side of the scene's box.
    int max_clusters = 2400;             ///< At most, and a seventh of the structure (1000 at least): small ones merge.
    int max_cells = 300;                 ///< Parts of the merged clusters, for which rows are made.
    double flow_seconds = 10.0;  ///< Rough amount of work, after which portals keep a coarse answer; 0: no limit.
    int threads = 0;             ///< 0: as many as the machine has.
    std::function<void(double share)> progress;  ///< Told from any thread how much is done, 0 to 1; may be empty.
};

struct VisibilityStats {
    int structure_polygons = 0;
    int detail_polygons = 0;
    int leaves = 0;
    int solid_leaves = 0;  ///< Inside of walls: an eye there sees everything.
    int clusters = 0;
    int portals = 0;
    int coarse_portals = 0;              ///< Portals whose flow ran out of budget and kept the coarse answer.
    double average_visible_share = 1.0;  ///< Triangles in a row over all, mean over the clusters with an opening.
    double seconds = 0.0;
    std::vector<Shortfall> shortfalls;  ///< Of what was compiled just now; a compiled level does not keep them.
};

/// What can be seen from where: a BSP over the structure, and for each of its clusters the chunks to draw.
struct Visibility {
    BspTree tree;
    LeafRows rows;                                    ///< Clusters by clusters.
    LeafRows slot_rows;                               ///< Clusters by slots: what is drawn.
    std::vector<ChunkSlot> slots;                     ///< Objects in order, then their chunks.
    std::vector<std::uint32_t> first_slot_of_object;  ///< One more than there are objects.
    PortalGraph portals;                              ///< Between clusters, metres from the grid's origin; to be shown.
    std::vector<Box> cluster_boxes;                   ///< World space; to be shown.
    VisibilityStats stats;
};

/// Visibility::slots and first_slot_of_object alone: they follow from the scene. `chunks_of_mesh`: one entry for each
/// mesh.
void number_slots(const Scene& scene, std::span<const MeshChunks> chunks_of_mesh, Visibility& visibility);

/// The tree that build_visibility() begins with, with the pieces of its polygons, to be measured. `area_m2` becomes the
/// area of the polygons.
BspBuild build_sight_tree(const Scene& scene, const Level& level, const VisibilityOptions& options,
                          VisibilityStats& stats, double& area_m2);

/// Compiles the visibility of a scene.
///
/// Structure is what Level::structure names, else what lies in the largest planes; see choose_structure(). Only opaque
/// and static triangles block, never mask, blend or animated ones. A surface blocks only from the sides from which it
/// is drawn: a single-sided wall seen from behind is transparent, so what lies before it is seen from there. Unsealed
/// and empty scenes work: outside is leaves like any other. Never hides what can be seen through an opening wider than
/// kCrackWidth; where a budget runs out, more is visible, never less. `chunks_of_mesh`: one entry for each mesh of the
/// scene.
Visibility build_visibility(const Scene& scene, const Level& level, std::span<const MeshChunks> chunks_of_mesh,
                            const VisibilityOptions& options);

/// Sets `is_visible` to one byte per slot: 1 if the chunk may be seen by an eye within `near_radius_m` of `eye_world`
/// (the near plane pokes through walls). An eye inside of a wall or outside of the compiled box sees everything.
void visible_chunks(const Visibility& visibility, const glm::dvec3& eye_world, double near_radius_m,
                    std::vector<std::uint8_t>& is_visible_by_chunk_slot);

/// The same for what is seen from any place of a flat convex pane, such as what a mirror shows: the rows of all leaves
/// that it touches. A pane that reaches out of the compiled box, or lies in walls alone, sees everything.
void chunks_before_pane(const Visibility& visibility, std::span<const glm::dvec3> outline_world,
                        std::vector<std::uint8_t>& is_visible_by_chunk_slot);

/// Clusters (merged leaves) in the union of the rows that visible_chunks() reads at that place, for statistics.
int visible_leaf_count(const Visibility& visibility, const glm::dvec3& eye_world, double near_radius_m);

}  // namespace hw
