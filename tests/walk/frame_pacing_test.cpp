#include "hatchway/walk/frame_pacing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace {

/// A machine: milliseconds for a quality at a time. Returns every quality that was drawn.
using Machine = std::function<double(const hw::FrameQuality&, double time_s)>;

struct Drive {
    hw::PacingState state;
    int changes = 0;
    double time_s = 0.0;
};

Drive run_for(double seconds, const Machine& machine, double target_fps = 30.0, Drive run = {})
{
    const double end_s = run.time_s + seconds;
    while (run.time_s < end_s) {
        const hw::FrameQuality quality = hw::quality_of(run.state);
        const double ms = machine(quality, run.time_s);
        run.state = hw::after_frame(run.state, {target_fps}, ms);
        run.changes += hw::quality_of(run.state) == quality ? 0 : 1;
        run.time_s += std::max(ms / 1000.0, 1.0 / target_fps);
    }
    return run;
}

double software_ms(const hw::FrameQuality& quality, double at_one_sample)
{
    const double pixels = quality.render_scale * quality.render_scale;
    return (0.2 + 0.8 * pixels) * at_one_sample * (quality.samples == 4 ? 2.4 : 1.0);
}

}  // namespace

TEST(frame_pacing, a_fast_machine_keeps_the_best_quality)
{
    const Drive run = run_for(60.0, [](const auto& quality, double) { return software_ms(quality, 3.0); });
    EXPECT_EQ(run.changes, 0);
    EXPECT_EQ(hw::quality_of(run.state), (hw::FrameQuality{4, 1.0f}));
}

TEST(frame_pacing, samples_go_before_resolution)
{
    const Drive run = run_for(20.0, [](const auto& quality, double) { return software_ms(quality, 28.0); });
    EXPECT_EQ(hw::quality_of(run.state), (hw::FrameQuality{1, 1.0f}));
}

TEST(frame_pacing, a_slow_machine_falls_within_a_second_until_the_rate_holds)
{
    const auto machine = [](const auto& quality, double) { return software_ms(quality, 50.0); };
    const Drive run = run_for(6.0, machine);
    EXPECT_LE(machine(hw::quality_of(run.state), 0.0), 1000.0 / 30.0 * 1.1);
    EXPECT_LE(run.changes, 3);
}

TEST(frame_pacing, a_very_slow_machine_does_not_wait_for_a_whole_window)
{
    const Drive run = run_for(13.0, [](const auto&, double) { return 2000.0; });
    EXPECT_EQ(hw::quality_of(run.state), hw::frame_qualities().back());
}

TEST(frame_pacing, a_hopeless_machine_stays_on_the_last_rung)
{
    const Drive run = run_for(60.0, [](const auto& quality, double) { return software_ms(quality, 900.0); });
    EXPECT_EQ(hw::quality_of(run.state), hw::frame_qualities().back());
}

TEST(frame_pacing, quality_comes_back_where_the_scene_is_light_again)
{
    const auto machine = [](const auto& quality, double time_s) {
        return software_ms(quality, time_s < 20.0 ? 60.0 : 4.0);
    };
    const Drive run = run_for(60.0, machine);
    EXPECT_EQ(hw::quality_of(run.state), (hw::FrameQuality{4, 1.0f}));
}

TEST(frame_pacing, what_was_learnt_at_a_heavy_place_does_not_bar_the_way_back_at_a_light_one)
{
    const auto machine = [](const auto& quality, double time_s) {
        return software_ms(quality, time_s < 20.0 ? 30.0 : 10.0);
    };
    const Drive run = run_for(40.0, machine);
    EXPECT_EQ(hw::quality_of(run.state), (hw::FrameQuality{4, 1.0f}));
}

TEST(frame_pacing, between_two_rungs_it_does_not_pump)
{
    // At 85 % the frame has room; at 100 % it is a little late: a climb is tried once.
    const Machine machine = [](const hw::FrameQuality& quality, double) {
        return quality.samples == 4 ? 90.0 : quality.render_scale == 1.0f ? 38.0 : 20.0;
    };
    const Drive first = run_for(60.0, machine);
    Drive later = run_for(180.0, machine, 30.0, first);
    EXPECT_LE(first.changes, 12);
    EXPECT_LE(later.changes - first.changes, 10);
}

TEST(frame_pacing, a_machine_that_slows_down_only_after_a_while_is_not_tried_for_ever)
{
    double full_since_s = 0.0;
    const Machine machine = [&](const hw::FrameQuality& quality, double time_s) {
        if (quality.samples == 4) return 90.0;
        if (quality.render_scale < 1.0f) full_since_s = time_s;
        return time_s - full_since_s < 1.0 ? 20.0 : 45.0;
    };
    const Drive run = run_for(240.0, machine);
    EXPECT_LE(run.changes, 8);
}

TEST(frame_pacing, a_glance_at_a_light_corner_does_not_change_the_picture)
{
    const Drive run = run_for(60.0, [](const auto& quality, double time_s) {
        return software_ms(quality, std::fmod(time_s, 4.0) < 1.0 ? 4.0 : 28.0);
    });
    EXPECT_LE(run.changes, 1);
}

TEST(frame_pacing, one_slow_frame_changes_nothing)
{
    int frame = 0;
    const Drive run = run_for(
        30.0, [&](const auto& quality, double) { return ++frame % 20 == 0 ? 400.0 : software_ms(quality, 8.0); });
    EXPECT_EQ(run.changes, 0);
}

TEST(frame_pacing, frames_right_after_a_change_are_not_looked_at)
{
    const hw::PacingState fresh;
    hw::PacingState state = hw::after_frame(fresh, {}, 5000.0);
    state = hw::after_frame(state, {}, 5000.0);
    EXPECT_EQ(state.frame_count, 0);
    EXPECT_EQ(hw::after_frame(state, {}, 5.0).frame_count, 1);
}

TEST(frame_pacing, equal_times_give_equal_decisions)
{
    const auto machine = [](const auto& quality, double time_s) {
        return software_ms(quality, 25.0 + 20.0 * std::sin(time_s));
    };
    const Drive a = run_for(30.0, machine);
    const Drive b = run_for(30.0, machine);
    EXPECT_EQ(a.changes, b.changes);
    EXPECT_EQ(a.state.rung, b.state.rung);
    EXPECT_EQ(a.state.step_cost, b.state.step_cost);
}

TEST(frame_pacing, says_what_it_does)
{
    EXPECT_EQ(hw::describe({4, 1.0f}), "4 samples");
    EXPECT_EQ(hw::describe({1, 0.7f}), "1 sample, 70 % of the resolution");
}
