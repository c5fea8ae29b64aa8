#include "hatchway/walk/player.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <optional>

namespace hw {
namespace {

constexpr double kStandingPull_s = 0.07;  // time constants: how quickly speed follows the wish
constexpr double kFlyingPull_s = 0.12;
constexpr double kFallingPull_s = 0.45;
constexpr double kEyePull_s = 0.09;
constexpr double kFastestFall_mps = 55.0;
constexpr double kHighestPitch_rad = 1.553;  // 89 degrees
constexpr double kWedged_s = 0.1;            // falling without getting anywhere for so long is standing
constexpr double kBelowWorld_m = 8.0;        // fallen so far below everything, nothing will be met any more
constexpr double kBuildingSize_m = 12.0;
constexpr double kSmallest_m = 3.0, kLargest_m = 3000.0;
constexpr double kStandingReach_m = 0.5;  // a camera this near to standing height stands

/// The part of a difference that is left to go after a tick, for a pull with this time constant.
double kept(double pull_s)
{
    return std::exp(-kPlayerTick_s / pull_s);
}

glm::dvec3 forward_of(double yaw_rad)
{
    return {-std::sin(yaw_rad), 0.0, -std::cos(yaw_rad)};
}

glm::dvec3 right_of(double yaw_rad)
{
    return {std::cos(yaw_rad), 0.0, -std::sin(yaw_rad)};
}

glm::dvec3 direction_of(double yaw_rad, double pitch_rad)
{
    return forward_of(yaw_rad) * std::cos(pitch_rad) + glm::dvec3(0.0, std::sin(pitch_rad), 0.0);
}

/// At most unit length: walking obliquely is not faster.
glm::dvec3 limited(const glm::dvec3& wish)
{
    const double length = glm::length(wish);
    return length > 1.0 ? wish / length : wish;
}

double speed(const PlayerInput& input, double mps, const PlayerBody& body)
{
    return mps * input.speed_factor * (input.is_fast ? body.fast_factor : 1.0);
}

/// The box that a walker has a reason to be in; empty without collision.
Box world_box(const CollisionWorld& world)
{
    return world.nodes.empty() ? Box{} : world.nodes.front().bounds;
}

double scale_of(const PlayerBody& body)
{
    return body.eye_m / PlayerBody{}.eye_m;
}

void fly(PlayerState& state, const PlayerInput& input, const PlayerBody& body, const CollisionWorld& world)
{
    const glm::dvec3 wish = limited(direction_of(state.yaw_rad, state.pitch_rad) * input.forward +
                                    right_of(state.yaw_rad) * input.right + glm::dvec3(0.0, input.up, 0.0));
    const glm::dvec3 goal = wish * speed(input, body.fly_mps, body);
    state.velocity = glm::mix(goal, state.velocity, kept(kFlyingPull_s));
    state.is_carried = false;
    if (!body.is_solid) {
        state.foot_world += state.velocity * kPlayerTick_s;
        return;
    }
    const Motion motion = move_in_flight(world, body.gait, state.foot_world, state.velocity, kPlayerTick_s);
    state.foot_world = motion.foot_world;
    state.velocity = motion.velocity;
}

void stand_or_fall(PlayerState& state, const Motion& motion)
{
    state.foot_world = motion.foot_world;
    state.velocity = motion.velocity;
    state.is_carried = motion.is_carried;
    if (motion.is_carried) state.velocity.y = 0.0;
    if (motion.is_carried && motion.is_firm) state.safe_foot_world = state.foot_world;
    const bool is_wedged = !motion.is_carried && motion.has_touched && glm::length(motion.velocity) < 0.05;
    state.wedged_s = is_wedged ? state.wedged_s + kPlayerTick_s : 0.0;
    if (state.wedged_s < kWedged_s) return;
    state.is_carried = true;
    state.velocity.y = 0.0;
}

/// The move, unless it ends where nothing stops a fall: then what of it leads along the edge of the world, else up and
/// down alone, else none. A fall onto an edge slides off it, so that even the way straight down can lead out.
template <typename Move>
Motion within_world(const PlayerState& state, const PlayerBody& body, const CollisionWorld& world, const Move& move)
{
    const double x = state.velocity.x, y = state.velocity.y, z = state.velocity.z;
    for (const glm::dvec3& way : {state.velocity, {x, y, 0.0}, {0.0, y, z}, {0.0, y, 0.0}}) {
        const Motion motion = move(way);
        if (stops_a_fall(world, body.gait, motion.foot_world)) return motion;
    }
    return {.foot_world = state.foot_world, .has_touched = true};
}

void walk(PlayerState& state, const PlayerInput& input, const PlayerBody& body, const CollisionWorld& world)
{
    const glm::dvec3 wish = limited(forward_of(state.yaw_rad) * input.forward + right_of(state.yaw_rad) * input.right);
    const glm::dvec3 goal = wish * speed(input, body.walk_mps, body);
    const double pull = kept(state.is_carried ? kStandingPull_s : kFallingPull_s);
    state.velocity.x = glm::mix(goal.x, state.velocity.x, pull);
    state.velocity.z = glm::mix(goal.z, state.velocity.z, pull);
    if (state.is_carried && input.wants_jump) {
        state.velocity.y = body.jump_mps;
        state.is_carried = false;
    }
    if (state.is_carried) {
        const double before_m = state.foot_world.y;
        stand_or_fall(state, within_world(state, body, world, [&](const glm::dvec3& way) {
                          return move_on_ground(world, body.gait, state.foot_world, way, kPlayerTick_s);
                      }));
        if (state.is_carried) state.eye_offset_m -= state.foot_world.y - before_m;
        return;
    }
    const double fastest = kFastestFall_mps * scale_of(body);
    state.velocity.y = std::max(-fastest, state.velocity.y - body.gravity_mps2 * kPlayerTick_s);
    stand_or_fall(state, within_world(state, body, world, [&](const glm::dvec3& way) {
                      return move_through_air(world, body.gait, state.foot_world, way, kPlayerTick_s);
                  }));
}

/// Back to where it stood last, when it fell out of the world or sits inside of something.
void return_to_safety(PlayerState& state)
{
    state.foot_world = state.safe_foot_world;
    state.velocity = glm::dvec3(0.0);
    state.last_foot_world = state.foot_world;
    state.eye_offset_m = 0.0;
    ++state.put_back_count;
}

void free_from_solids(PlayerState& state, const PlayerBody& body, const CollisionWorld& world)
{
    if (!overlaps(world, state.foot_world, body.gait.capsule)) return;
    if (const auto place = push_out(world, state.foot_world, body.gait.capsule, body.gait.capsule.height_m))
        state.foot_world = *place;
    else
        return_to_safety(state);
}

/// A free place near the foot: where pushing leads out of what is solid, else the nearest of places around it.
std::optional<glm::dvec3> free_place_near(const CollisionWorld& world, const glm::dvec3& foot, const Capsule& capsule)
{
    constexpr int kRings = 8, kSides = 12;
    const double reach_m = 2.0 * capsule.height_m;
    if (const auto place = push_out(world, foot, capsule, reach_m)) return place;
    for (int ring = 1; ring <= kRings; ++ring) {
        const double away_m = reach_m * ring / kRings;
        for (const double rise : {0.0, 0.5, 1.0, -0.5, -1.0}) {
            const double flat_m = away_m * std::sqrt(1.0 - rise * rise);
            for (int side = 0; side < (flat_m > 0.0 ? kSides : 1); ++side) {
                const double angle = side * glm::two_pi<double>() / kSides;
                const glm::dvec3 way(flat_m * std::cos(angle), away_m * rise, flat_m * std::sin(angle));
                if (!overlaps(world, foot + way, capsule)) return foot + way;
            }
        }
    }
    return std::nullopt;
}

/// Flying far away loses the scene: a wide box around it is the end of the world.
void keep_in_world(PlayerState& state, const PlayerBody& body, const CollisionWorld& world)
{
    const Box box = world_box(world);
    if (box.is_empty()) return;
    const double margin = glm::length(box.size()) + 20.0 * scale_of(body);
    state.foot_world = glm::clamp(state.foot_world, box.min - margin, box.max + margin);
    if (!state.is_flying && state.foot_world.y < box.min.y - kBelowWorld_m * scale_of(body)) return_to_safety(state);
}

bool is_moving(const PlayerInput& input, const PlayerState& state)
{
    return input.forward != 0.0 || input.right != 0.0 || input.up != 0.0 || input.wants_jump ||
           glm::length(state.velocity) > 1e-3;
}

void turn(PlayerState& state, double left_rad, double up_rad)
{
    state.yaw_rad += left_rad;
    state.pitch_rad = std::clamp(state.pitch_rad + up_rad, -kHighestPitch_rad, kHighestPitch_rad);
}

void tick(PlayerState& state, const PlayerInput& input, const PlayerBody& body, const CollisionWorld& world)
{
    state.last_foot_world = state.foot_world;
    state.last_yaw_rad = state.yaw_rad;
    state.last_pitch_rad = state.pitch_rad;
    state.last_eye_offset_m = state.eye_offset_m;
    turn(state, input.turn_left * body.turn_radps * kPlayerTick_s, input.turn_up * body.turn_radps * kPlayerTick_s);
    // A camera's exact place may touch a wall: nothing is put right before the walker moves.
    const bool moves = is_moving(input, state);
    const bool falls = !state.is_flying && !state.is_carried;
    if (!moves && !falls) return;
    if (body.is_solid) free_from_solids(state, body, world);
    if (falls && !stops_a_fall(world, body.gait, state.foot_world)) state.is_flying = true;
    if (state.is_flying || world.triangles.empty())
        fly(state, input, body, world);
    else
        walk(state, input, body, world);
    state.eye_offset_m *= kept(kEyePull_s);
    keep_in_world(state, body, world);
}

/// Turns by whole circles, so that hours of turning one way cost no precision; both ends of the tick alike.
void wrap_yaw(PlayerState& state)
{
    const double circles = std::round(state.yaw_rad / glm::two_pi<double>()) * glm::two_pi<double>();
    state.yaw_rad -= circles;
    state.last_yaw_rad -= circles;
}

}  // namespace

PlayerBody body_for(const Box& scene_bounds, bool is_level)
{
    PlayerBody body;
    const glm::dvec3 size = scene_bounds.is_empty() ? glm::dvec3(kBuildingSize_m) : scene_bounds.size();
    const double largest = std::max({size.x, size.y, size.z});
    if (is_level || (largest >= kSmallest_m && largest <= kLargest_m) || largest <= 0.0) return body;
    const double scale = largest / kBuildingSize_m;
    body.gait.capsule = {body.gait.capsule.radius_m * scale, body.gait.capsule.height_m * scale};
    body.is_solid = body.gait.capsule.radius_m > 20.0 * kCollisionSkin;
    for (double* measure :
         {&body.gait.step_m, &body.eye_m, &body.walk_mps, &body.fly_mps, &body.jump_mps, &body.gravity_mps2})
        *measure *= scale;
    return body;
}

PlayerState step(const PlayerState& state, const PlayerInput& input, const PlayerBody& body,
                 const CollisionWorld& world, double seconds)
{
    PlayerState next = state;
    // The mouse turns both ends of the tick: the picture follows the hand in the same frame.
    turn(next, input.look_left_rad, input.look_up_rad);
    next.last_yaw_rad += next.yaw_rad - state.yaw_rad;
    next.last_pitch_rad += next.pitch_rad - state.pitch_rad;
    next.rest_s += std::clamp(seconds, 0.0, kLongestFrame_s);
    while (next.rest_s >= kPlayerTick_s) {
        next.rest_s -= kPlayerTick_s;
        tick(next, input, body, world);
    }
    wrap_yaw(next);
    return next;
}

PlayerState placed_at(const Camera& camera, const PlayerBody& body, const CollisionWorld& world)
{
    const glm::dvec3 look = camera.target_world - camera.eye_world;
    PlayerState state;
    state.yaw_rad = look.x == 0.0 && look.z == 0.0 ? 0.0 : std::atan2(-look.x, -look.z);
    turn(state, 0.0, std::atan2(look.y, std::hypot(look.x, look.z)));
    state.foot_world = camera.eye_world - glm::dvec3(0.0, body.eye_m, 0.0);
    state.is_flying = true;
    if (body.is_solid) {
        const double reach = kStandingReach_m * scale_of(body);
        const glm::dvec3 foot = free_place_near(world, state.foot_world, body.gait.capsule).value_or(state.foot_world);
        const Motion standing = settle(world, body.gait, foot, reach);
        if (standing.is_carried && stops_a_fall(world, body.gait, standing.foot_world) &&
            glm::distance(standing.foot_world, state.foot_world) <= reach) {
            state.eye_offset_m = state.foot_world.y - standing.foot_world.y;
            state.is_flying = false;
            state.is_carried = true;
            state.foot_world = standing.foot_world;
        } else {
            state.foot_world = foot;
        }
    }
    state.safe_foot_world = state.last_foot_world = state.foot_world;
    state.last_yaw_rad = state.yaw_rad;
    state.last_pitch_rad = state.pitch_rad;
    state.last_eye_offset_m = state.eye_offset_m;
    return state;
}

PlayerState with_flight_toggled(const PlayerState& state, const PlayerBody& body)
{
    PlayerState next = state;
    next.is_flying = !state.is_flying || !body.is_solid;
    next.is_carried = false;
    next.wedged_s = 0.0;
    return next;
}

PlayerState in_world(const PlayerState& state, const PlayerBody& body, const CollisionWorld& world)
{
    PlayerState next = state;
    if (body.is_solid) free_from_solids(next, body, world);
    if (!next.is_flying)
        next.is_carried = settle(world, body.gait, next.foot_world, 0.01).is_carried &&
                          stops_a_fall(world, body.gait, next.foot_world);
    next.last_foot_world = next.foot_world;
    return next;
}

Camera camera_of(const PlayerState& state, const PlayerBody& body, double fov_deg)
{
    const double part = state.rest_s / kPlayerTick_s;
    const double yaw = glm::mix(state.last_yaw_rad, state.yaw_rad, part);
    const double pitch = glm::mix(state.last_pitch_rad, state.pitch_rad, part);
    const double offset = glm::mix(state.last_eye_offset_m, state.eye_offset_m, part);
    const glm::dvec3 foot = glm::mix(state.last_foot_world, state.foot_world, part);
    Camera camera{.name = "walk", .eye_world = foot + glm::dvec3(0.0, body.eye_m + offset, 0.0), .fov_deg = fov_deg};
    camera.target_world = camera.eye_world + direction_of(yaw, pitch);
    return camera;
}

}  // namespace hw
