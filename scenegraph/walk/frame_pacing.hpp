#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

namespace hw {

/// How much work one frame is given.
struct FrameQuality {
    int samples = 4;            ///< Multisampling, 4 or 1.
    float render_scale = 1.0f;  ///< Of the window's size in each direction, in (0, 1].

    bool operator==(const FrameQuality&) const = default;
};

/// The rungs that pacing climbs, best first.
std::span<const FrameQuality> frame_qualities();

/// What pacing tries to hold.
struct PacingGoal {
    double target_fps = 30.0;  ///< In [1, 1000].
};

/// Pacing's memory. A fresh one starts at the best rung and knows nothing.
struct PacingState {
    static constexpr int kWindow = 9;  ///< Frames that are looked at together: fewer where they are very slow.

    int rung = 0;  ///< Index into frame_qualities().
    std::array<double, kWindow> frame_ms{};
    int frame_count = 0;           ///< Filled entries of `frame_ms`.
    int frames_to_skip = 2;        ///< Frames right after a change pay for new targets; they are not looked at.
    double calm_s = 0.0;           ///< How long there has been room for a better rung.
    std::optional<int> left_rung;  ///< The rung before the last change, and what it took: tells what the step costs.
    double left_ms = 0.0;
    std::array<double, 8> step_cost{};  ///< Time at a rung divided by time at the next lower one; 0: not measured yet.
};

/// The state after one more frame that took `frame_ms` of work (drawing until the GPU is done, without waiting for the
/// display). A function of the measured times alone: equal times, equal decisions.
///
/// Falls at once when the median of a window of frames misses the goal by more than a tenth. Climbs one rung only after
/// two seconds of frames so fast that the better rung will fit, too: what it costs is learnt from each fall, so that
/// the picture does not pump. One slow frame (a hot reload, a page fault) changes nothing.
PacingState after_frame(const PacingState& state, const PacingGoal& goal, double frame_ms);

/// The quality for the next frame.
FrameQuality quality_of(const PacingState& state);

/// "1 sample, 70 % of the resolution": for the overlay.
std::string describe(const FrameQuality& quality);

}  // namespace hw
