#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "hatchway/geometry/surface/surface.hpp"

namespace hw {

/// One object among those that are drawn together.
struct SeamObject {
    const Surface* surface = nullptr;
    glm::dmat4 world_from_object{1.0};
    std::uint32_t style = 0;       ///< Only objects of one style hide each other's seams.
    bool is_double_sided = false;  ///< Both sides of its faces are seen.
};

/// What remains of an edge of which a part is hidden.
struct KeptPiece {
    std::array<glm::vec3, 2> ends;  ///< Object space.
    std::uint32_t edge = 0;
};

/// The lines of one object that are not drawn because the surface goes on across them, in the object itself or in a
/// neighbour.
struct Seams {
    std::vector<std::uint32_t> hidden;         ///< Edge ids, rising: borders and creases not drawn at all.
    std::vector<std::uint32_t> partly_hidden;  ///< Edge ids, rising: replaced by the pieces in `kept`.
    std::vector<KeptPiece> kept;               ///< Drawn as borders, where their edge would be.
};

struct SeamOptions {
    float tolerance_m = 1e-4f;  ///< World space: lines closer than this coincide.
    float flat_rad = 0.0175f;   ///< A surface that folds by less goes on across the line.
    float crease_rad = 0.35f;   ///< Edges folded by less are not drawn anyway and not looked at.
};

/// Finds the seams of kit pieces set side by side: where borders and creases of same-style objects coincide, also in
/// parts (T-junctions), a line stays only if the visible surface is folded there or ends there. One result for each
/// object, in order.
std::vector<Seams> find_seams(std::span<const SeamObject> objects, const SeamOptions& options = {});

}  // namespace hw
