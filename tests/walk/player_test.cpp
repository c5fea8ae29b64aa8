#include "hatchway/walk/player.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/walk/solids.hpp"

namespace {

using hw::test::Solids;

const hw::PlayerBody kBody;
const hw::PlayerInput kForward{.forward = 1.0};

/// Stands at `foot`, looks along -z.
hw::PlayerState standing_at(const glm::dvec3& foot, const hw::CollisionWorld& world)
{
    const glm::dvec3 eye = foot + glm::dvec3(0.0, kBody.eye_m, 0.0);
    return hw::placed_at({.eye_world = eye, .target_world = eye - glm::dvec3(0, 0, 1)}, kBody, world);
}

hw::PlayerState after(double seconds, hw::PlayerState state, const hw::PlayerInput& input,
                      const hw::CollisionWorld& world, double frame_s = 1.0 / 60.0)
{
    const auto frames = static_cast<int>(std::lround(seconds / frame_s));
    for (int i = 0; i < frames; ++i) state = hw::step(state, input, kBody, world, frame_s);
    return state;
}

/// A room of 12 x 12 x 4 m with walls of 0.3 m, a stair, a table, a low beam, a ramp and a narrow passage.
Solids furnished_room()
{
    Solids room;
    room.box({-6, -0.3, -6}, {6, 0, 6}).box({-6, 4, -6}, {6, 4.3, 6});
    room.box({-6.3, 0, -6}, {-6, 4, 6}).box({6, 0, -6}, {6.3, 4, 6});
    room.box({-6, 0, -6.3}, {6, 4, -6}).box({-6, 0, 6}, {6, 4, 6.3});
    for (int i = 0; i < 8; ++i) room.box({-6, 0, -2 + i * 0.28}, {-4.5, (i + 1) * 0.18, -2 + (i + 1) * 0.28});
    room.box({-6, 0, 0.24}, {-4.5, 1.44, 3});
    room.box({1, 0.7, 1}, {2.5, 0.78, 2}).box({-1, 1.2, -4}, {3, 1.4, -3.8}).box({2, 0, -3}, {4, 0.9, -2.2});
    room.box({4.6, 0, -6}, {4.8, 3, -1}).box({3.8, 0, 3}, {4.0, 0.3, 6});
    room.quad({0, 0, 3}, {2, 0, 3}, {2, 1.2, 5}, {0, 1.2, 5}).quad({-3, 0, 3}, {-1, 0, 3}, {-1, 3, 4}, {-3, 3, 4});
    return room;
}

void expect_inside_the_room(const hw::PlayerState& state, const std::string& when)
{
    const glm::dvec3 p = state.foot_world;
    ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) << when;
    ASSERT_LE(std::max(std::abs(p.x), std::abs(p.z)), 6.0 - 0.29) << when;
    ASSERT_GE(p.y, -0.01) << when;
    ASSERT_LE(p.y, 4.0 - 1.79) << when;
}

hw::PlayerInput random_input(std::mt19937& random)
{
    const auto axis = [&] { return static_cast<double>(random() % 3) - 1.0; };
    hw::PlayerInput input{.forward = axis(), .right = axis(), .up = axis(), .turn_left = axis()};
    input.look_left_rad = (random() % 2000 / 1000.0 - 1.0) * 3.0;
    input.look_up_rad = random() % 2000 / 1000.0 - 1.0;
    input.is_fast = random() % 2 == 0;
    input.wants_jump = random() % 4 == 0;
    input.speed_factor = random() % 16 == 0 ? 10.0 : 1.0;
    return input;
}

}  // namespace

TEST(player, stands_still_on_the_floor)
{
    const auto world = Solids().floor().world();
    const hw::PlayerState start = standing_at({0, 0, 0}, world);
    EXPECT_TRUE(start.is_carried);
    const hw::PlayerState later = after(10.0, start, {}, world);
    EXPECT_EQ(later.foot_world, start.foot_world);
}

TEST(player, walks_at_its_speed)
{
    const auto world = Solids().floor().world();
    const hw::PlayerState later = after(5.0, standing_at({0, 0, 0}, world), kForward, world);
    EXPECT_NEAR(-later.foot_world.z, 5.0 * kBody.walk_mps, 0.3);
    EXPECT_NEAR(later.foot_world.x, 0.0, 1e-6);
    EXPECT_NEAR(later.foot_world.y, 0.0, 3.0 * hw::kCollisionSkin);
    EXPECT_TRUE(later.is_carried);
}

TEST(player, oblique_walking_is_not_faster)
{
    const auto world = Solids().floor().world();
    const auto start = standing_at({0, 0, 0}, world);
    const auto oblique = after(4.0, start, {.forward = 1.0, .right = 1.0}, world);
    EXPECT_NEAR(glm::length(oblique.foot_world), glm::length(after(4.0, start, kForward, world).foot_world), 0.01);
}

TEST(player, goes_the_same_way_at_30_60_and_240_frames_a_second)
{
    const auto world = furnished_room().world();
    const hw::PlayerInput input{.forward = 1.0, .right = 0.3, .turn_left = 0.4};
    const auto start = standing_at({0, 0, 5.0}, world);
    const auto reference = after(6.0, start, input, world, 1.0 / 60.0);
    for (const double fps : {10.0, 30.0, 240.0, 1000.0}) {
        const auto other = after(6.0, start, input, world, 1.0 / fps);
        // A tick more or less by rounding of the frame times.
        EXPECT_LT(
            glm::distance(hw::camera_of(other, kBody, 60).eye_world, hw::camera_of(reference, kBody, 60).eye_world),
            0.03)
            << fps;
    }
}

TEST(player, the_view_moves_evenly_at_frame_rates_that_do_not_divide_the_ticks)
{
    const auto world = Solids().floor().world();
    auto state = after(2.0, standing_at({0, 0, 0}, world), kForward, world);
    for (int frame = 0; frame < 200; ++frame) {
        const auto next = hw::step(state, kForward, kBody, world, 1.0 / 144.0);
        const double way =
            glm::distance(hw::camera_of(next, kBody, 60).eye_world, hw::camera_of(state, kBody, 60).eye_world);
        EXPECT_NEAR(way, kBody.walk_mps / 144.0, 1e-3);
        state = next;
    }
}

TEST(player, the_mouse_turns_in_the_same_frame_whatever_its_time)
{
    const auto world = Solids().floor().world();
    for (const double frame_s : {0.0, 0.001, 0.25}) {
        const auto turned =
            hw::step(standing_at({0, 0, 0}, world), {.look_left_rad = 0.5, .look_up_rad = 0.2}, kBody, world, frame_s);
        const hw::Camera camera = hw::camera_of(turned, kBody, 60);
        const glm::dvec3 look = camera.target_world - camera.eye_world;
        EXPECT_NEAR(std::atan2(-look.x, -look.z), 0.5, 1e-12) << frame_s;
        EXPECT_NEAR(std::asin(look.y), 0.2, 1e-12) << frame_s;
    }
}

TEST(player, never_looks_over_its_own_back)
{
    const auto world = Solids().floor().world();
    const auto up = hw::step(standing_at({0, 0, 0}, world), {.look_up_rad = 50.0}, kBody, world, 0.1);
    EXPECT_LT(up.pitch_rad, 1.5708);
}

TEST(player, slides_along_a_wall)
{
    const auto world = Solids().floor().box({-50, 0, -3}, {50, 3, -2.8}).world();
    auto state = standing_at({0, 0, 0}, world);
    state.yaw_rad = state.last_yaw_rad = glm::radians(45.0);
    const auto later = after(5.0, state, kForward, world);
    EXPECT_NEAR(later.foot_world.z, -2.8 + 0.3, 0.01);
    EXPECT_LT(later.foot_world.x, -6.0);
}

TEST(player, does_not_climb_a_wall_by_walking_into_it)
{
    const auto world = Solids().floor().box({-50, 0, -3}, {50, 1.0, -2.8}).world();
    const auto later = after(5.0, standing_at({0, 0, 0}, world), kForward, world);
    EXPECT_NEAR(later.foot_world.y, 0.0, 0.005);
    EXPECT_NEAR(later.foot_world.z, -2.5, 0.01);
}

TEST(player, an_inner_corner_holds_it_still)
{
    const auto world = Solids().floor().box({-50, 0, -3}, {50, 3, -2.8}).box({1, 0, -50}, {1.2, 3, 50}).world();
    auto state = standing_at({0, 0, 0}, world);
    state.yaw_rad = state.last_yaw_rad = glm::radians(-40.0);
    state = after(5.0, state, kForward, world);
    const auto later = after(1.0, state, kForward, world);
    EXPECT_NEAR(state.foot_world.x, 0.7, 0.01);
    EXPECT_LT(glm::distance(state.foot_world, later.foot_world), 0.01);
}

TEST(player, nothing_is_tunnelled_from_10_to_1000_frames_a_second)
{
    const auto world = Solids().floor().box({-50, 0, -4.001}, {50, 3, -4}).world();
    for (const double fps : {10.0, 30.0, 60.0, 144.0, 1000.0}) {
        const hw::PlayerInput rush{.forward = 1.0, .speed_factor = 10.0, .is_fast = true};
        const auto later = after(3.0, standing_at({0, 0, 0}, world), rush, world, 1.0 / fps);
        EXPECT_GT(later.foot_world.z, -4.0) << fps;
    }
}

TEST(player, a_floor_thinner_than_a_millimetre_stops_a_fall_from_a_kilometre)
{
    const auto world = Solids().floor().world();
    auto state = standing_at({0, 0, 0}, world);
    state.foot_world.y = 1000.0;
    state.is_carried = state.is_flying = false;
    const auto later = after(40.0, state, {}, world, 1.0 / 10.0);
    EXPECT_TRUE(later.is_carried);
    EXPECT_NEAR(later.foot_world.y, 0.0, 0.005);
}

TEST(player, climbs_stairs_and_comes_down_them_without_leaving_the_ground)
{
    for (const double rise : {0.1, 0.18, 0.25, 0.34}) {
        const auto world = Solids().floor().stairs(10, rise, 0.28).box({-2, 0, -8}, {2, 10 * rise, -2.8}).world();
        auto state = standing_at({0, 0, 1.0}, world);
        double quickest = 0.0;
        for (int frame = 0; frame < 60 * 4; ++frame) {
            const double y = hw::camera_of(state, kBody, 60).eye_world.y;
            state = hw::step(state, kForward, kBody, world, 1.0 / 60.0);
            quickest = std::max(quickest, hw::camera_of(state, kBody, 60).eye_world.y - y);
            EXPECT_TRUE(state.is_carried) << rise << " frame " << frame << " y " << state.foot_world.y;
            if (HasFailure()) return;
        }
        EXPECT_NEAR(state.foot_world.y, 10 * rise, 0.005);
        EXPECT_LT(quickest, 0.12) << "the view jerks";
        for (int frame = 0; frame < 60 * 4; ++frame) {
            state = hw::step(state, {.forward = -1.0}, kBody, world, 1.0 / 60.0);
            EXPECT_TRUE(state.is_carried) << rise << " down, frame " << frame;
        }
        EXPECT_NEAR(state.foot_world.y, 0.0, 0.005);
    }
}

TEST(player, a_step_of_40_cm_is_too_high_and_one_of_34_is_not)
{
    for (const auto& [rise, climbs] : {std::pair(0.34, true), std::pair(0.40, false)}) {
        const auto world = Solids().floor().box({-5, 0, -9}, {5, rise, -2}).world();
        const auto later = after(3.0, standing_at({0, 0, 0}, world), kForward, world);
        EXPECT_NEAR(later.foot_world.y, climbs ? rise : 0.0, 0.005);
    }
}

TEST(player, a_step_under_a_low_ceiling_is_not_climbed)
{
    const auto world = Solids().floor().box({-5, 0, -9}, {5, 0.3, -2}).box({-5, 1.95, -9}, {5, 2.2, -1.5}).world();
    const auto later = after(3.0, standing_at({0, 0, 0}, world), kForward, world);
    EXPECT_LT(later.foot_world.y, 0.2) << "its foot may lean on the edge, no more";
    EXPECT_GT(later.foot_world.z, -2.0);
}

TEST(player, a_beam_at_the_height_of_the_forehead_stops_it)
{
    const auto world = Solids().floor().box({-5, 1.6, -3}, {5, 1.7, -2.8}).world();
    const auto later = after(3.0, standing_at({0, 0, 0}, world), kForward, world);
    EXPECT_GT(later.foot_world.z, -2.8);
}

TEST(player, walks_up_45_degrees_as_fast_as_on_the_level_and_not_up_60)
{
    for (const double angle : {10.0, 30.0, 45.0}) {
        const auto world = Solids().floor().ramp(angle, 20.0).world();
        const auto state = after(4.0, standing_at({0, 0, 1.0}, world), kForward, world);
        EXPECT_NEAR(-state.foot_world.z, 4.0 * kBody.walk_mps - 1.0, 0.4) << angle;
        EXPECT_TRUE(state.is_carried) << angle;
    }
    const auto world = Solids().floor().ramp(60.0, 20.0).world();
    const auto state = after(4.0, standing_at({0, 0, 1.0}, world), kForward, world);
    EXPECT_LT(state.foot_world.y, 0.36);
}

TEST(player, walks_down_a_ramp_without_hopping)
{
    const auto world = Solids().floor().ramp(40.0, 20.0).world();
    auto state = standing_at({0, 10.0 * std::tan(glm::radians(40.0)) + 0.1, -10.0}, world);
    for (int frame = 0; frame < 150; ++frame) {
        state = hw::step(state, {.forward = -1.0}, kBody, world, 1.0 / 60.0);
        EXPECT_TRUE(state.is_carried) << frame;
    }
}

TEST(player, stands_still_on_a_slope_that_carries_and_slides_off_one_that_does_not)
{
    const auto gentle = Solids().floor().ramp(44.0, 20.0).world();
    auto state = standing_at({0, 10.0 * std::tan(glm::radians(44.0)) + 0.1, -10.0}, gentle);
    ASSERT_TRUE(state.is_carried);
    EXPECT_EQ(after(5.0, state, {}, gentle).foot_world, state.foot_world);

    const auto steep = Solids().floor().ramp(65.0, 20.0).world();
    state = standing_at({0, 0, 5.0}, steep);
    state.foot_world = {0, 23.0, -10.0};
    state.is_carried = false;
    state = after(8.0, state, {}, steep);
    EXPECT_NEAR(state.foot_world.y, 0.0, 0.01);
    EXPECT_TRUE(state.is_carried);
}

TEST(player, walks_off_a_ledge_and_lands)
{
    const auto world = Solids().floor().box({-5, 0, -2}, {5, 3, 5}).world();
    auto state = standing_at({0, 3, 0}, world);
    ASSERT_TRUE(state.is_carried);
    state = after(4.0, state, kForward, world);
    EXPECT_NEAR(state.foot_world.y, 0.0, 0.005);
    EXPECT_TRUE(state.is_carried);
}

TEST(player, jumps_half_a_metre_and_lands)
{
    const auto world = Solids().floor().world();
    auto state = standing_at({0, 0, 0}, world);
    double highest = 0.0;
    state = hw::step(state, {.wants_jump = true}, kBody, world, 1.0 / 60.0);
    for (int frame = 0; frame < 120; ++frame) {
        state = hw::step(state, {}, kBody, world, 1.0 / 60.0);
        highest = std::max(highest, state.foot_world.y);
    }
    EXPECT_NEAR(highest, 0.45, 0.06);
    EXPECT_TRUE(state.is_carried);
}

TEST(player, a_groove_between_two_steep_slopes_does_not_hold_it_for_good)
{
    const double rise = 4.0 * std::tan(glm::radians(60.0));
    const auto world = Solids()
                           .quad({-50, 0, 0}, {50, 0, 0}, {50, rise, -4}, {-50, rise, -4})
                           .quad({-50, 0, 0}, {50, 0, 0}, {50, rise, 4}, {-50, rise, 4})
                           .world();
    auto state = standing_at({0, 2, 0}, world);
    state.is_flying = false;
    state = after(3.0, state, {}, world);
    const auto along = after(3.0, state, {.right = 1.0}, world);
    EXPECT_GT(glm::distance(state.foot_world, along.foot_world), 1.0);
}

TEST(player, wedged_in_a_pit_it_stands_and_can_jump_out)
{
    Solids ground;
    ground.quad({-9, 0, -9}, {9, 0, -9}, {9, 0, -0.4}, {-9, 0, -0.4})
        .quad({-9, 0, 0.4}, {9, 0, 0.4}, {9, 0, 9}, {-9, 0, 9});
    ground.quad({-9, 0, -0.4}, {-0.4, 0, -0.4}, {-0.4, 0, 0.4}, {-9, 0, 0.4});
    ground.quad({0.4, 0, -0.4}, {9, 0, -0.4}, {9, 0, 0.4}, {0.4, 0, 0.4});
    const glm::dvec3 tip(0, -0.9, 0), corners[] = {{-0.4, 0, -0.4}, {0.4, 0, -0.4}, {0.4, 0, 0.4}, {-0.4, 0, 0.4}};
    for (int i = 0; i < 4; ++i) ground.quad(corners[i], corners[(i + 1) % 4], tip, tip);
    const auto world = ground.world();
    auto state = standing_at({0, 0.5, 0}, world);
    state.is_flying = state.is_carried = false;
    state = after(2.0, state, {}, world);
    EXPECT_LT(state.foot_world.y, -0.1);
    const auto jumping = after(4.0, state, {.forward = 1.0, .wants_jump = true}, world);
    EXPECT_LT(jumping.foot_world.z, -2.0);
}

TEST(player, a_start_inside_of_a_wall_is_moved_out)
{
    const auto world = Solids().floor().box({-50, 0, -3}, {50, 3, -2.8}).world();
    const auto state = standing_at({0, 0, -2.7}, world);
    EXPECT_FALSE(hw::overlaps(world, state.foot_world, kBody.gait.capsule));
    EXPECT_TRUE(state.is_carried);
}

TEST(player, a_camera_in_the_air_flies_and_keeps_its_exact_eye)
{
    const auto world = Solids().floor().world();
    const hw::Camera camera{.eye_world = {1, 12, 3}, .target_world = {0, 0, 0}};
    const auto state = after(2.0, hw::placed_at(camera, kBody, world), {}, world);
    EXPECT_TRUE(state.is_flying);
    EXPECT_LT(glm::distance(hw::camera_of(state, kBody, 60).eye_world, camera.eye_world), 1e-9);
}

TEST(player, a_camera_near_standing_height_keeps_its_exact_eye_until_the_walker_moves)
{
    const auto world = Solids().floor().world();
    const hw::Camera camera{.eye_world = {1, 1.45, 3}, .target_world = {0, 1, 0}};
    auto state = after(2.0, hw::placed_at(camera, kBody, world), {}, world);
    EXPECT_FALSE(state.is_flying);
    EXPECT_LT(glm::distance(hw::camera_of(state, kBody, 60).eye_world, camera.eye_world), 1e-9);
    state = after(2.0, state, kForward, world);
    EXPECT_NEAR(hw::camera_of(state, kBody, 60).eye_world.y, 1.7, 0.01);
}

TEST(player, flying_slides_along_walls_and_goes_up_and_down)
{
    const auto world = furnished_room().world();
    auto state = hw::with_flight_toggled(standing_at({0, 0, 0}, world), kBody);
    state = after(3.0, state, {.up = 1.0}, world);
    EXPECT_NEAR(state.foot_world.y, 4.0 - 1.8, 0.01);
    state = after(6.0, state, {.forward = 1.0, .is_fast = true}, world);
    EXPECT_GT(state.foot_world.z, -6.0);
    state = hw::with_flight_toggled(state, kBody);
    state = after(3.0, state, {}, world);
    EXPECT_TRUE(state.is_carried);
}

/// Six metres square, with nothing around it.
hw::CollisionWorld plate_in_the_void()
{
    return Solids().quad({-3, 0, -3}, {3, 0, -3}, {3, 0, 3}, {-3, 0, 3}).world();
}

TEST(player, the_edge_of_the_world_stops_walkers_and_jumpers_from_every_direction)
{
    const auto world = plate_in_the_void();
    for (int direction = 0; direction < 24; ++direction)
        for (const bool jumps : {false, true}) {
            auto state = standing_at({0, 0, 0}, world);
            state.yaw_rad = state.last_yaw_rad = direction * 0.2617993878;
            state = after(20.0, state, {.forward = 1.0, .is_fast = jumps, .wants_jump = jumps}, world);
            state = after(3.0, state, {}, world);
            EXPECT_TRUE(state.is_carried);
            EXPECT_FALSE(state.is_flying);
            EXPECT_EQ(state.put_back_count, 0u);
            const double way = std::max(std::abs(state.foot_world.x), std::abs(state.foot_world.z));
            EXPECT_GT(way, 2.9);
            EXPECT_LT(way, 3.0 + kBody.gait.capsule.radius_m);
        }
}

TEST(player, outside_of_a_fence_at_the_edge_of_the_world_a_fall_onto_the_fence_does_not_slide_out_of_it)
{
    // Two centimetres carry nobody, and a hair of the body is still over the last ground.
    const auto world = Solids().box({-3, -0.5, -3}, {3, 0, 3}).box({2.956, 0, -2}, {2.976, 0.2, 2}).world();
    int tried = 0;
    for (double away_m = 0.268; away_m < 0.2712; away_m += 0.0002) {
        auto state = standing_at({0, 0, 0}, world);
        const double reach_m = kBody.gait.capsule.radius_m + hw::kCollisionSkin, flat_m = away_m + 0.024;
        state.foot_world = {3.0 + away_m, 0.2 - 0.3 + std::sqrt(reach_m * reach_m - flat_m * flat_m) + 1e-3, 0.0};
        state.last_foot_world = state.foot_world;
        state.is_carried = false;
        if (!hw::stops_a_fall(world, kBody.gait, state.foot_world)) continue;
        ++tried;
        state = after(2.0, state, {}, world);
        EXPECT_FALSE(state.is_flying) << away_m;
        EXPECT_TRUE(state.is_carried) << away_m;
        EXPECT_LT(state.foot_world.x, 3.271) << away_m;
        state.yaw_rad = state.last_yaw_rad = 1.5707963268;
        state = after(2.0, state, {.forward = 1.0, .wants_jump = true}, world);
        EXPECT_LT(state.foot_world.x, 2.0) << "a jump leads back over the fence, " << away_m;
    }
    EXPECT_GT(tried, 10);
}

TEST(player, the_edge_of_the_world_is_walked_along)
{
    const auto world = plate_in_the_void();
    auto state = standing_at({-2, 0, -2}, world);
    state = after(10.0, state, {.forward = 1.0, .right = 0.5}, world);
    EXPECT_GT(state.foot_world.x, 2.9);
}

TEST(player, the_edge_of_a_roof_over_ground_stops_nobody)
{
    const auto world = Solids().floor().box({-3, 0, -3}, {3, 3, 3}).world();
    auto state = after(4.0, standing_at({0, 3, 0}, world), kForward, world);
    EXPECT_LT(state.foot_world.z, -3.0);
    EXPECT_NEAR(after(1.0, state, {}, world).foot_world.y, 0.0, 0.01);
}

TEST(player, who_ends_a_flight_over_the_void_flies_on)
{
    const auto world = plate_in_the_void();
    auto state = hw::with_flight_toggled(standing_at({0, 0, 0}, world), kBody);
    state = after(3.0, state, kForward, world);
    ASSERT_LT(state.foot_world.z, -4.0);
    state = after(5.0, hw::with_flight_toggled(state, kBody), {}, world);
    EXPECT_TRUE(state.is_flying);
    EXPECT_EQ(state.put_back_count, 0u);
    EXPECT_GT(state.foot_world.y, -0.5);
}

TEST(player, without_anything_to_stand_on_it_floats)
{
    const hw::CollisionWorld nothing;
    const auto state = after(5.0, standing_at({0, 0, 0}, nothing), {}, nothing);
    EXPECT_EQ(state.foot_world.y, 0.0);
    EXPECT_LT(after(5.0, state, kForward, nothing).foot_world.z, -10.0);
}

TEST(player, a_door_as_wide_as_a_door_lets_it_through)
{
    const auto world = Solids()
                           .floor()
                           .box({-50, 0, -3}, {-0.4, 3, -2.8})
                           .box({0.4, 0, -3}, {50, 3, -2.8})
                           .box({-0.4, 2.0, -3}, {0.4, 3, -2.8})
                           .world();
    EXPECT_LT(after(4.0, standing_at({0.05, 0, 0}, world), kForward, world).foot_world.z, -6.0);
}

TEST(player, a_small_model_gets_a_body_in_proportion)
{
    hw::Box bounds;
    bounds.add({-0.6, 0, -0.6});
    bounds.add({0.6, 0.5, 0.6});
    const hw::PlayerBody small = hw::body_for(bounds, false);
    EXPECT_NEAR(small.eye_m, 0.17, 1e-9);
    EXPECT_TRUE(small.is_solid);
    EXPECT_EQ(hw::body_for(bounds, true).eye_m, 1.7);
    bounds = {};
    bounds.add({0, 0, 0});
    bounds.add({1e-6, 1e-6, 1e-6});
    EXPECT_FALSE(hw::body_for(bounds, false).is_solid);
    EXPECT_EQ(hw::body_for(hw::Box{}, false).eye_m, 1.7);
}

TEST(player_fuzz, random_inputs_and_frame_times_never_leave_the_room)
{
    const auto world = furnished_room().world();
    std::mt19937 random(11);
    auto state = standing_at({0, 0, 0}, world);
    for (int round = 0; round < 20000; ++round) {
        const hw::PlayerInput input = random_input(random);
        if (random() % 200 == 0) state = hw::with_flight_toggled(state, kBody);
        const int frames = 1 + random() % 8;
        const double fps = std::pow(10.0, 1.0 + random() % 1000 / 500.0);
        for (int i = 0; i < frames; ++i) state = hw::step(state, input, kBody, world, 1.0 / fps);
        expect_inside_the_room(state, "round " + std::to_string(round));
        if (HasFatalFailure()) return;
    }
}

TEST(player_fuzz, wherever_a_camera_is_the_body_begins_outside_of_what_is_solid)
{
    const auto world = furnished_room().world();
    std::mt19937 random(13);
    const auto within = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 eye(within(-6.3, 6.3), within(-0.3, 4.3), within(-6.3, 6.3));
        const auto state = hw::placed_at({.eye_world = eye, .target_world = eye + glm::dvec3(1, 0, 0)}, kBody, world);
        ASSERT_FALSE(hw::overlaps(world, state.foot_world, kBody.gait.capsule))
            << eye.x << ' ' << eye.y << ' ' << eye.z;
    }
}

TEST(player_fuzz, from_wherever_it_got_it_gets_away_again)
{
    const auto world = furnished_room().world();
    std::mt19937 random(12);
    auto state = standing_at({0, 0, 0}, world);
    for (int round = 0; round < 200; ++round) {
        for (int i = 0; i < 20; ++i) state = after(0.25, state, random_input(random), world);
        state.is_flying = false;
        state = after(2.0, state, {}, world);
        double furthest = 0.0;
        for (int direction = 0; direction < 8; ++direction) {
            auto attempt = state;
            attempt.yaw_rad = attempt.last_yaw_rad = direction * 0.7853981;
            attempt = after(1.5, attempt, {.forward = 1.0, .wants_jump = direction % 2 == 1}, world);
            furthest = std::max(furthest, glm::distance(attempt.foot_world, state.foot_world));
        }
        ASSERT_GT(furthest, 0.5) << "round " << round << " at " << state.foot_world.x << ' ' << state.foot_world.y
                                 << ' ' << state.foot_world.z;
    }
}
