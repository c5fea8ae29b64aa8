#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "hatchway/world/level.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// A plane of the world, metres. A place is in front of it where height() is positive.
struct MirrorPlane {
    glm::dvec3 normal_world{0.0, 1.0, 0.0};  ///< Unit.
    double offset_m = 0.0;                   ///< Of the plane from the origin, along the normal.

    double height(const glm::dvec3& place_world) const;
    /// The place on the other side, as far away.
    glm::dvec3 reflected(const glm::dvec3& place_world) const;
    /// The same plane, its front where its back was.
    MirrorPlane turned() const { return {-normal_world, -offset_m}; }
};

/// An object that mirrors what is before it.
struct Mirror {
    ObjectId object = 0;
    MirrorPlane plane;                      ///< In front of it its faces are drawn.
    bool is_two_sided = false;              ///< They are drawn from behind, too.
    std::vector<glm::dvec3> outline_world;  ///< The corners of its convex hull, at least three.
    float reflectance = 0.9f;               ///< How much of its own look the reflection takes, [0, 1].
    glm::vec3 tint_linear{1.0f};            ///< What the reflection is multiplied by.
};

/// The mirrors that the level names; of two rules for an object the later one wins. What has no faces is none. Throws
/// hw::Error for a rule that reaches no node, and for a mesh that is not flat.
std::vector<Mirror> find_mirrors(const Level& level, const Scene& scene);

}  // namespace hw
