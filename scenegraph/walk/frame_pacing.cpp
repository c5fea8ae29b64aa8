#include "hatchway/walk/frame_pacing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

// Multisampling goes first: on a software renderer it costs more than half of the frame and shows least in motion.
constexpr std::array<FrameQuality, 5> kQualities{{{4, 1.0f}, {1, 1.0f}, {1, 0.85f}, {1, 0.7f}, {1, 0.5f}}};

constexpr double kLate = 1.1;        // a tenth over the goal's time is late
constexpr double kRoom = 0.85;       // a better rung must be expected to need no more than this part of the time
constexpr double kSampleCost = 2.2;  // 4 samples against 1, until both were measured (measured: 31 and 74 ms)
constexpr double kCalm_s = 2.0;
constexpr int kSkippedFrames = 2;
constexpr int kFewestFrames = 3;
constexpr double kLongWindow_ms = 500.0;

double median_of(const PacingState& state)
{
    std::array<double, PacingState::kWindow> values = state.frame_ms;
    std::nth_element(values.begin(), values.begin() + state.frame_count / 2, values.begin() + state.frame_count);
    return values[state.frame_count / 2];
}

/// Nobody wants to wait for nine frames of a second each: three tell a slow one from a slow machine.
bool is_window_full(const PacingState& state)
{
    if (state.frame_count == PacingState::kWindow) return true;
    const double sum_ms = std::accumulate(state.frame_ms.begin(), state.frame_ms.begin() + state.frame_count, 0.0);
    return state.frame_count >= kFewestFrames && sum_ms >= kLongWindow_ms;
}

double pixel_cost(const FrameQuality& quality)
{
    return static_cast<double>(quality.render_scale) * quality.render_scale * (quality.samples > 1 ? kSampleCost : 1.0);
}

/// Time at a rung divided by time at the next lower one: as measured, else by their pixels.
double step_cost(const PacingState& state, int rung)
{
    if (state.step_cost[rung] > 0.0) return state.step_cost[rung];
    return pixel_cost(kQualities[rung]) / pixel_cost(kQualities[rung + 1]);
}

/// The first window after a fall tells what the step costs here. Times of far apart moments would not: the view
/// differs.
void learn_step(PacingState& state, double ms)
{
    if (state.left_rung == state.rung - 1) state.step_cost[*state.left_rung] = std::clamp(state.left_ms / ms, 1.0, 4.0);
    state.left_rung.reset();
}

PacingState moved_to(PacingState state, int rung, double ms)
{
    state.left_rung = state.rung;
    state.left_ms = ms;
    state.rung = rung;
    state.frames_to_skip = kSkippedFrames;
    state.calm_s = 0.0;
    return state;
}

/// Down to the first rung that is expected to hold the time.
PacingState fallen(const PacingState& state, double ms, double goal_ms)
{
    const int last = static_cast<int>(kQualities.size()) - 1;
    int rung = state.rung;
    for (double expected_ms = ms; rung < last && expected_ms > kLate * goal_ms; ++rung)
        expected_ms /= step_cost(state, rung);
    return moved_to(state, rung, ms);
}

/// A full window has been measured: fall, climb, or stay.
PacingState after_window(PacingState state, double goal_ms)
{
    const double ms = std::max(1e-3, median_of(state));
    const double frames = std::exchange(state.frame_count, 0);
    const int last = static_cast<int>(kQualities.size()) - 1;
    learn_step(state, ms);
    const bool has_room = state.rung > 0 && ms * step_cost(state, state.rung - 1) <= kRoom * goal_ms;
    // A frame lasts at least as long as the goal gives it, so that calm is counted in what a watch would show.
    state.calm_s = has_room ? state.calm_s + frames * goal_ms / 1000.0 : 0.0;
    if (ms > kLate * goal_ms && state.rung < last) return fallen(state, ms, goal_ms);
    return state.calm_s >= kCalm_s ? moved_to(state, state.rung - 1, ms) : state;
}

}  // namespace

std::span<const FrameQuality> frame_qualities()
{
    return kQualities;
}

PacingState after_frame(const PacingState& state, const PacingGoal& goal, double frame_ms)
{
    HW_ASSERT(goal.target_fps >= 1.0 && goal.target_fps <= 1000.0);
    PacingState next = state;
    if (next.frames_to_skip > 0) {
        --next.frames_to_skip;
        return next;
    }
    next.frame_ms[next.frame_count++] = frame_ms;
    return is_window_full(next) ? after_window(next, 1000.0 / goal.target_fps) : next;
}

FrameQuality quality_of(const PacingState& state)
{
    return kQualities[state.rung];
}

std::string describe(const FrameQuality& quality)
{
    const std::string samples = quality.samples == 1 ? "1 sample" : fmt::format("{} samples", quality.samples);
    if (quality.render_scale == 1.0f) return samples;
    return fmt::format("{}, {:.0f} % of the resolution", samples, 100.0 * quality.render_scale);
}

}  // namespace hw
