#include "hatchway/walk/stillness.hpp"

#include <glm/geometric.hpp>

namespace hw {
namespace {

constexpr double kStill_s = 0.3;
constexpr double kRounding = 1e-12;  // of the distance from the world's origin and to the target

}  // namespace

Stillness after_moment(const Stillness& state, bool has_changed, double now_s)
{
    if (has_changed) return {.since_s = now_s};
    if (state.work != FrameWork::paced) return {state.since_s, FrameWork::nothing};
    return {state.since_s, now_s - state.since_s < kStill_s ? FrameWork::paced : FrameWork::sharp};
}

bool are_alike(const Camera& a, const Camera& b)
{
    const double most = kRounding * (glm::length(b.eye_world) + glm::distance(b.eye_world, b.target_world));
    return glm::distance(a.eye_world, b.eye_world) <= most && glm::distance(a.target_world, b.target_world) <= most &&
           a.fov_deg == b.fov_deg && a.orthographic_height_m == b.orthographic_height_m && a.roll_deg == b.roll_deg;
}

}  // namespace hw
