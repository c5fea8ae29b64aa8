#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "hatchway/world/scene.hpp"

namespace hw {

/// An edge of an object's mesh in world space, as the ray judge looks at it. Faces on it are known by their normals,
/// not of unit length, as they are wound.
struct JudgedEdge {
    glm::dvec3 from{0.0};
    glm::dvec3 to{0.0};
    std::vector<glm::dvec3> normals;
    bool is_crease = false;  ///< Folded by more than the crease angle, or meant by the artist.
    bool is_sure = true;     ///< False: more than two faces meet, or one is thinner than a thousandth of its
                             ///< length. It may be a line or none.
    bool is_culled = false;
};

/// All edges of an object: vertices are one where their floats are equal. The artist means edges that are marked in the
/// file, and smaller folds across which the model's own normals split at both ends, unless all folds of a connected
/// piece are split: such a piece is shaded flat. Written anew from docs/method/silhouettes.md, with nothing of
/// geometry/.
std::vector<JudgedEdge> judged_edges(const Scene& scene, ObjectId id, double crease_rad);

}  // namespace hw
