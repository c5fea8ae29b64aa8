#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hatchway/geometry/exact/viewpoint.hpp"
#include "hatchway/geometry/surface/surface.hpp"

namespace hw {

/// How facing is decided. `exact` is certified; the other two exist to report what certainty costs.
enum class FacingPrecision : std::uint8_t { exact, single_only, double_only };

/// `brute` looks at every face and edge, `hierarchy` only into clusters of faces that the contour may pass through,
/// which needs the exact precision and a surface that has clusters. `automatic` takes the hierarchy where there is one.
enum class SilhouetteMethod : std::uint8_t { automatic, brute, hierarchy };

struct SilhouetteOptions {
    float crease_rad = 0.7f;  ///< For drawn_contours(): edges folded by more are creases and not among the result.
    FacingPrecision precision = FacingPrecision::exact;
    SilhouetteMethod method = SilhouetteMethod::automatic;
};

/// What the last calls cost. Sums until reset by the caller.
struct SilhouetteCounters {
    std::uint64_t objects_without_work = 0;  ///< No candidates: nothing was computed.
    std::uint64_t faces_tested = 0;
    std::uint64_t double_stage = 0;  ///< Faces that the float filter left open.
    std::uint64_t exact_stage = 0;   ///< Faces that doubles left open.
    std::uint64_t edges_tested = 0;
    std::uint64_t edges_found = 0;
};

/// Memory kept between calls: once it has grown to the largest surface, no call allocates. One for each thread.
struct SilhouetteScratch {
    std::vector<std::uint8_t> facing;  ///< 1: the face looks at the viewer. Only after find_facing().
    std::vector<std::uint32_t> edges;
    std::vector<std::uint32_t> front;  ///< A bit for each face, or for each group of clusters: front for certain.
    std::vector<std::uint32_t> open;   ///< The same: not decided.
    std::vector<std::uint32_t> mixed;  ///< Clusters that were looked into.
    SilhouetteCounters counters;
};

/// Decides the facing of every face into scratch.facing: front-facing means that the viewer is strictly on the outer
/// side of the face's plane. Collinear faces take the facing of the neighbour across their longest edge.
void find_facing(const Surface& surface, const Viewpoint& viewpoint_object, FacingPrecision precision,
                 SilhouetteScratch& scratch);

inline bool is_front_facing(const SilhouetteScratch& scratch, std::uint32_t face)
{
    return scratch.facing[face] != 0;
}

/// Every edge of exactly two faces that differ in facing, whatever its group. Each once, in an order that depends on
/// the method alone; ids rise by brute force. The span lives in `scratch` until its next use.
std::span<const std::uint32_t> all_silhouettes(const Surface& surface, const Viewpoint& viewpoint_object,
                                               const SilhouetteOptions& options, SilhouetteScratch& scratch);

/// The contour candidates among them: what is drawn each frame beside borders, artist's edges and creases. A surface
/// without candidates costs nothing.
/// Source: Freudenberg, Masuch, Strothotte. Walk-Through Illustrations. Eurographics 2001, section 3.1.2.
std::span<const std::uint32_t> drawn_contours(const Surface& surface, const Viewpoint& viewpoint_object,
                                              const SilhouetteOptions& options, SilhouetteScratch& scratch);

}  // namespace hw
