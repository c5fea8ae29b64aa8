#include "hatchway/walk/stillness.hpp"

namespace hw {
namespace {

constexpr double kStill_s = 0.3;

}  // namespace

Stillness after_moment(const Stillness& state, bool has_changed, double now_s)
{
    if (has_changed) return {.since_s = now_s};
    if (state.work != FrameWork::paced) return {state.since_s, FrameWork::nothing};
    return {state.since_s, now_s - state.since_s < kStill_s ? FrameWork::paced : FrameWork::sharp};
}

}  // namespace hw
