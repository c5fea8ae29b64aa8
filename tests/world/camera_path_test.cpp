#include "hatchway/world/camera_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace hw {
namespace {

CameraPath path_of(std::vector<PathKey> keys)
{
    CameraPath path;
    path.keys = std::move(keys);
    return path;
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b)
{
    EXPECT_LT(glm::length(a - b), 1e-9);
}

TEST(camera_path, passes_its_keys)
{
    const CameraPath path = path_of({{0, {0, 0, 0}, {0, 0, -1}}, {1, {1, 2, 3}, {5, 2, 3}}, {3, {4, 0, 0}, {4, 5, 0}}});
    for (const PathKey& key : path.keys) {
        expect_near(camera_at(path, key.t_s).eye_world, key.position);
        expect_near(camera_at(path, key.t_s).target_world, key.look_at);
    }
}

TEST(camera_path, is_clamped_to_its_ends)
{
    const CameraPath path = path_of({{1, {0, 0, 0}, {0, 0, -1}}, {2, {1, 0, 0}, {1, 0, -1}}});
    expect_near(camera_at(path, -5).eye_world, {0, 0, 0});
    expect_near(camera_at(path, 99).eye_world, {1, 0, 0});
}

TEST(camera_path, keys_on_a_line_at_even_speed_give_even_motion)
{
    const CameraPath path =
        path_of({{0, {0, 0, 0}, {0, 0, -1}}, {1, {1, 0, 0}, {1, 0, -1}}, {3, {3, 0, 0}, {3, 0, -1}}});
    for (double t = 0; t <= 3; t += 0.1) expect_near(camera_at(path, t).eye_world, {t, 0, 0});
}

TEST(camera_path, velocity_has_no_jump_at_a_key)
{
    const CameraPath path = path_of({{0, {0, 0, 0}, {0, 0, -1}},
                                     {1, {1, 2, 0}, {1, 0, -1}},
                                     {4, {3, -1, 5}, {3, 0, -1}},
                                     {5, {0, 0, 0}, {1, 1, 1}}});
    const double h = 1e-6;
    const auto eye = [&](double t) { return camera_at(path, t).eye_world; };
    for (const double t : {1.0, 4.0}) {
        EXPECT_LT(glm::length((eye(t) - eye(t - h)) / h - (eye(t + h) - eye(t)) / h), 1e-3);
    }
}

TEST(camera_path, the_direction_turns_evenly)
{
    const CameraPath path = path_of({{0, {0, 0, 0}, {0, 0, -2}}, {1, {0, 0, 0}, {2, 0, 0}}});
    const Camera half = camera_at(path, 0.5);
    expect_near(half.target_world, {std::sqrt(2.0), 0, -std::sqrt(2.0)});
}

TEST(camera_path, opposite_directions_turn_through_the_horizon)
{
    const CameraPath path = path_of({{0, {0, 0, 0}, {0, 0, -1}}, {1, {0, 0, 0}, {0, 0, 1}}});
    const Camera half = camera_at(path, 0.5);
    EXPECT_NEAR(half.target_world.y, 0.0, 1e-9);
    EXPECT_NEAR(glm::length(half.target_world), 1.0, 1e-9);
}

TEST(camera_path, frames_are_fps_times_duration_and_one)
{
    CameraPath path = path_of({{0, {}, {0, 0, -1}}, {4, {}, {0, 0, -1}}});
    EXPECT_EQ(path_frame_count(path), 101);
    path.keys[1].t_s = 0.1;
    path.fps = 30;
    EXPECT_EQ(path_frame_count(path), 4);
    EXPECT_NEAR(path_frame_time(path, 3), 0.1, 1e-12);
    EXPECT_EQ(path_frame_count(path_of({{2, {}, {0, 0, -1}}})), 1);
}

TEST(camera_path, a_single_key_is_a_still)
{
    const CameraPath path = path_of({{2, {1, 2, 3}, {1, 2, 0}}});
    expect_near(camera_at(path, 7).eye_world, {1, 2, 3});
    expect_near(camera_at(path, 7).target_world, {1, 2, 0});
}

}  // namespace
}  // namespace hw
