#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "hatchway/walk/capsule_motion.hpp"
#include "hatchway/world/collision/collision.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// The walker's measures. Lengths and speeds scale together for models that are no buildings.
struct PlayerBody {
    Gait gait;
    double eye_m = 1.7;     ///< Over the foot.
    double walk_mps = 2.2;  ///< An unhurried visitor; a fast one is `fast_factor` quicker.
    double fly_mps = 4.0;
    double fast_factor = 2.6;
    double jump_mps = 3.0;  ///< Rises by about 0.45 m.
    double gravity_mps2 = 9.81;
    double turn_radps = 1.8;  ///< By keys; the mouse turns as far as it moves.
    bool is_solid = true;     ///< False: flies through everything and never walks.
};

/// The body for a scene. A level is in metres. A bare model that is far smaller or larger than a building gets a body
/// in proportion, so that it can be walked around; where that is too small for collision the body is not solid.
PlayerBody body_for(const Box& scene_bounds, bool is_level);

/// What the walker wants now. Axes are in [-1, 1].
struct PlayerInput {
    double forward = 0.0;
    double right = 0.0;
    double up = 0.0;         ///< Flying only.
    double turn_left = 0.0;  ///< Held keys: radians follow from time.
    double turn_up = 0.0;
    double look_left_rad = 0.0;  ///< The mouse: turned at once, whatever the time of the frame.
    double look_up_rad = 0.0;
    double speed_factor = 1.0;
    bool is_fast = false;
    bool wants_jump = false;
};

/// Where the walker is, after the last whole tick of kPlayerTick_s, and the one before.
struct PlayerState {
    glm::dvec3 foot_world{0.0};
    glm::dvec3 velocity{0.0};
    double yaw_rad = 0.0;    ///< 0 looks along -z, positive turns left.
    double pitch_rad = 0.0;  ///< Positive looks up.
    bool is_flying = false;
    bool is_carried = false;           ///< Stands on ground.
    double eye_offset_m = 0.0;         ///< Fades while moving: steps and camera places do not jerk the view.
    double wedged_s = 0.0;             ///< How long it has been falling without getting anywhere.
    glm::dvec3 safe_foot_world{0.0};   ///< Where it stood firmly last.
    std::uint32_t put_back_count = 0;  ///< How often it was put back there.

    glm::dvec3 last_foot_world{0.0};  ///< A tick ago: the view lies between the two.
    double last_yaw_rad = 0.0;
    double last_pitch_rad = 0.0;
    double last_eye_offset_m = 0.0;
    double rest_s = 0.0;  ///< Time that was given but not ticked yet, below kPlayerTick_s.
};

inline constexpr double kPlayerTick_s = 1.0 / 120.0;
/// Longer frames (a breakpoint, a dragged window) lose time instead of running far ahead.
inline constexpr double kLongestFrame_s = 0.25;

/// The state after `seconds` of `input`. Time passes in whole ticks, so equal inputs lead along equal ways at any frame
/// rate. Where nothing below would stop a fall, the world has an edge: who walks or jumps there stops, and who ends his
/// flight there flies on. Who is caught in a solid that nothing leads out of goes back to where it stood last.
PlayerState step(const PlayerState& state, const PlayerInput& input, const PlayerBody& body,
                 const CollisionWorld& world, double seconds);

/// A walker whose eye is at the camera's and who looks where it looks. It stands where a floor is near below, and the
/// view eases to its own height as it moves; else it flies. Never inside of solids unless nothing near is free.
PlayerState placed_at(const Camera& camera, const PlayerBody& body, const CollisionWorld& world);

/// Walks instead of flying, or the other way round. A body that is not solid keeps flying.
PlayerState with_flight_toggled(const PlayerState& state, const PlayerBody& body);

/// The state in another world: kept, moved out of what is solid now.
PlayerState in_world(const PlayerState& state, const PlayerBody& body, const CollisionWorld& world);

/// What the walker sees, between the last two ticks.
Camera camera_of(const PlayerState& state, const PlayerBody& body, double fov_deg);

}  // namespace hw
