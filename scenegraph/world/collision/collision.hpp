#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "hatchway/core/box.hpp"
#include "hatchway/world/level.hpp"
#include "hatchway/world/looks.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// An upright walker: a ball of `radius_m` swept along y. Its place is its foot, the lowest point, in world space.
struct Capsule {
    double radius_m = 0.3;
    double height_m = 1.8;  ///< From foot to crown, at least twice the radius.
};

/// The first touch of a moving capsule.
struct SweepHit {
    bool is_hit = false;
    double fraction = 1.0;        ///< How much of the way is free, in [0, 1].
    glm::dvec3 foot_world{0.0};   ///< Where the capsule stops: at the touch, or at the end of the way.
    glm::dvec3 normal{0.0};       ///< Unit, from the obstacle towards the capsule; zero without a hit.
    glm::dvec3 point_world{0.0};  ///< Where they touch.
    ObjectId object = 0;          ///< What was hit.
};

/// The triangles that stop a walker, static, world space, and a bounding volume hierarchy over them.
struct CollisionWorld {
    struct Triangle {
        glm::dvec3 a{0.0}, b{0.0}, c{0.0};
        ObjectId object = 0;
    };
    struct BvhNode {
        Box bounds;
        std::uint32_t first = 0;  ///< First triangle of a leaf; of an inner node, its second child (the first is next).
        std::uint32_t count = 0;  ///< Triangles of a leaf; 0 for an inner node.
    };
    std::vector<Triangle> triangles;
    std::vector<BvhNode> nodes;  ///< Root first; none without triangles.
};

/// The collision world of the objects whose look says that they collide (all, where `looks` is empty). Both sides of a
/// triangle stop; animated objects and triangles without area take no part.
CollisionWorld build_collision_world(const Scene& scene, std::span<const ObjectLook> looks);

/// Moves the capsule's foot from `from_world` straight to `to_world`, continuously: nothing is tunnelled through,
/// whatever the length. A triangle that is touched or overlapped at the start stops it only if the way leads deeper.
/// `SweepHit::foot_world` keeps kCollisionSkin of distance from what was hit.
/// Method: conservative advancement of a convex pair along its separating direction.
SweepHit sweep_capsule(const CollisionWorld& world, const glm::dvec3& from_world, const glm::dvec3& to_world,
                       const Capsule& capsule);

/// True if the capsule at `foot_world` is nearer to a triangle than half of kCollisionSkin.
bool overlaps(const CollisionWorld& world, const glm::dvec3& foot_world, const Capsule& capsule);

/// The foot of a free place near `foot_world`, by moving away from what overlaps; nullopt if there is none within
/// `reach_m`. A free place is returned as it is.
std::optional<glm::dvec3> push_out(const CollisionWorld& world, const glm::dvec3& foot_world, const Capsule& capsule,
                                   double reach_m);

/// The distance in metres that a sweep keeps from obstacles.
inline constexpr double kCollisionSkin = 1e-3;

}  // namespace hw
