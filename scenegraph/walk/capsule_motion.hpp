#pragma once

#include <glm/vec3.hpp>

#include "hatchway/world/collision/collision.hpp"

namespace hw {

/// What a walker's body can do with the ground.
struct Gait {
    Capsule capsule;
    double step_m = 0.35;           ///< Highest step that is climbed without a jump, and snapped down to.
    double steepest_cosine = 0.64;  ///< Cosine of the steepest ground that carries: 50 degrees.
};

/// Where a move ended.
struct Motion {
    glm::dvec3 foot_world{0.0};
    glm::dvec3 velocity{0.0};  ///< The wished one without what the obstacles took.
    bool is_carried = false;   ///< It ended on ground that carries.
    bool is_firm = false;      ///< And that ground is level, not the edge of something.
    bool has_touched = false;  ///< Something was in the way.
};

/// Moves freely through the air: slides along whatever is hit, stops on ground that carries when falling.
/// The way is `velocity` times `seconds`.
Motion move_through_air(const CollisionWorld& world, const Gait& gait, const glm::dvec3& foot_world,
                        const glm::dvec3& velocity, double seconds);

/// Moves along the ground: keeps its horizontal speed up and down slopes that carry, takes everything else for a wall,
/// climbs steps and stays on the ground down steps. The vertical part of `velocity` is not read. Not carried at the
/// end: the ground fell away by more than a step, or is too steep.
Motion move_on_ground(const CollisionWorld& world, const Gait& gait, const glm::dvec3& foot_world,
                      const glm::dvec3& velocity, double seconds);

/// Moves in every direction alike, for flying: slides along whatever is hit and never lands.
Motion move_in_flight(const CollisionWorld& world, const Gait& gait, const glm::dvec3& foot_world,
                      const glm::dvec3& velocity, double seconds);

/// Whether something stops a fall from there, steep or level: else nothing lies below, or only what one slides off.
bool stops_a_fall(const CollisionWorld& world, const Gait& gait, const glm::dvec3& foot_world);

/// Lowers the foot to the ground that carries, at most `drop_m` below. Not carried when there is none: the foot stays.
Motion settle(const CollisionWorld& world, const Gait& gait, const glm::dvec3& foot_world, double drop_m);

}  // namespace hw
