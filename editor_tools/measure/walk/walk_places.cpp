#include "measure/walk/walk_places.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <set>

namespace hw::measure {
namespace {

constexpr std::size_t kScattered = 32;
constexpr std::uint32_t kScatterSeed = 1;
constexpr int kDirections = 8;
constexpr double kFrame_s = 1.0 / 30.0;
constexpr int kFramesAtMost = 60;  // until a foot is in the next cell, or does not get there

std::vector<PlayerState> standing(const std::vector<Camera>& cameras, const PlayerBody& body,
                                  const CollisionWorld& world)
{
    std::vector<PlayerState> places;
    for (const Camera& camera : cameras)
        if (const PlayerState state = placed_at(camera, body, world); state.is_carried) places.push_back(state);
    return places;
}

using Cell = std::array<std::int64_t, 3>;

Cell cell_of(const PlayerState& state, double cell_m)
{
    Cell cell;
    for (int axis = 0; axis < 3; ++axis)
        cell[axis] = static_cast<std::int64_t>(std::floor(state.foot_world[axis] / cell_m));
    return cell;
}

/// Walks straight on until the foot stands in another cell.
PlayerState walked(const Walker& walker, PlayerState state, double yaw_rad, double cell_m)
{
    const Cell from = cell_of(state, cell_m);
    state.yaw_rad = state.last_yaw_rad = yaw_rad;
    for (int frame = 0; frame < kFramesAtMost; ++frame) {
        state = walker(state, {.forward = 1.0}, kFrame_s);
        if (state.is_carried && cell_of(state, cell_m) != from) break;
    }
    return state;
}

}  // namespace

std::vector<PlayerState> named_places(const Level& level, const Scene& scene, const PlayerBody& body,
                                      const CollisionWorld& world)
{
    std::vector<Camera> cameras;
    const auto add = [&](const glm::dvec3& eye, const glm::dvec3& target) {
        cameras.push_back({.eye_world = eye, .target_world = target});
    };
    if (level.start) add(level.start->position, level.start->look_at);
    cameras.insert(cameras.end(), level.cameras.begin(), level.cameras.end());
    cameras.insert(cameras.end(), scene.cameras.begin(), scene.cameras.end());
    for (const CameraPath& path : level.paths)
        for (const PathKey& key : path.keys) add(key.position, key.look_at);
    return standing(cameras, body, world);
}

std::vector<PlayerState> scattered_places(const WalkOracle& oracle, const PlayerBody& body, const CollisionWorld& world)
{
    std::vector<Camera> cameras;
    const JudgedBody judged{body.gait.capsule.radius_m, body.gait.capsule.height_m, body.gait.step_m};
    for (const glm::dvec3& foot : oracle.standing_places(judged, kScattered, kScatterSeed)) {
        const glm::dvec3 eye = foot + glm::dvec3(0.0, body.eye_m, 0.0);
        cameras.push_back({.eye_world = eye, .target_world = eye + glm::dvec3(0.0, 0.0, -1.0)});
    }
    return standing(cameras, body, world);
}

std::vector<PlayerState> places_on_foot(const Walker& walker, std::span<const PlayerState> starts, double cell_m,
                                        std::size_t most)
{
    std::vector<PlayerState> places;
    std::set<Cell> reached;
    const auto add = [&](const PlayerState& state) {
        if (state.is_carried && !state.is_flying && places.size() < most &&
            reached.insert(cell_of(state, cell_m)).second)
            places.push_back(state);
    };
    for (const PlayerState& start : starts) add(start);
    for (std::size_t i = 0; i < places.size() && places.size() < most; ++i)
        for (int direction = 0; direction < kDirections; ++direction)
            add(walked(walker, PlayerState(places[i]), direction * 2.0 * std::numbers::pi / kDirections, cell_m));
    return places;
}

}  // namespace hw::measure
