#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "hatchway/core/box.hpp"
#include "hatchway/world/visibility/tree/portal_polygon.hpp"

namespace hw {

/// A plane through the scene as a bitmap: which texels a sight line may cross, from its front and from its back.
/// A texel is closed only if no opening touches it.
struct SightSlice {
    FlowPlane plane;  ///< Metres from the grid's origin.
    glm::dvec3 u{0.0}, v{0.0};
    double first_u = 0.0, first_v = 0.0;  ///< Corner of the bitmap, metres along u and v.
    double texel_m = 1.0;
    double margin_m = 1e-4;  ///< By which a cross-section grows: what is drawn was snapped.
    int columns = 0;
    int rows = 0;
    int words = 0;                                           ///< Per row.
    std::vector<std::uint64_t> open_forward, open_backward;  ///< Set where sight from behind, from the front, may pass.
};

/// Opens every texel that the convex polygon touches.
void open_polygon(SightSlice& slice, std::span<const glm::dvec3> corners, bool forward, bool backward);

/// Whether a sight line may cross the slice at a point of it. `side` is positive for sight from the front.
bool is_open_at(const SightSlice& slice, double side, const glm::dvec3& point);

/// Whether all lines from corner to corner of two boxes cross closed texels: their hull is the cross-section of the
/// shaft between the boxes. The plane parts them, the eyes lie on the side of `side`.
bool is_closed(const SightSlice& slice, double side, const Box& eyes, const Box& target);

}  // namespace hw
