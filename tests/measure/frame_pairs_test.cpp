#include "measure/hatching/frame_pairs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

using namespace hw;

namespace {

CameraPath straight_path()
{
    CameraPath path{.name = "straight"};
    path.keys.push_back({.t_s = 0.0, .position = {0, 1, 0}, .look_at = {0, 1, -10}});
    path.keys.push_back({.t_s = 4.0, .position = {0, 1, -8}, .look_at = {0, 1, -18}});
    return path;
}

}  // namespace

TEST(frame_pairs, a_path_has_neighbouring_frames_of_its_own_from_one_end_to_the_other)
{
    const CameraPath path = straight_path();
    const std::vector<FramePair> pairs = pairs_along(path, 48);
    ASSERT_EQ(pairs.size(), 48u);
    double last_z = 1.0;
    for (const FramePair& pair : pairs) {
        EXPECT_EQ(pair.path, "straight");
        EXPECT_LT(pair.before.eye_world.z, last_z) << "each pair is another";
        EXPECT_LT(pair.after.eye_world.z, pair.before.eye_world.z);
        EXPECT_LT(glm::distance(pair.before.eye_world, pair.after.eye_world), 0.5);
        last_z = pair.before.eye_world.z;
    }
    EXPECT_GT(pairs.front().before.eye_world.z, -0.5);
    EXPECT_LT(pairs.back().after.eye_world.z, -7.5);
}

TEST(frame_pairs, at_a_camera_a_walker_steps_ahead_and_aside_and_turns_half_a_degree)
{
    const Camera camera{.eye_world = {3, 1.7, 2}, .target_world = {3, 4.7, -2}};
    Camera parallel = camera, upright = camera;
    parallel.orthographic_height_m = 4.0;
    upright.target_world = {3, 9, 2};
    const Camera cameras[] = {camera, parallel, upright};
    const std::vector<FramePair> pairs = pairs_at(cameras);
    ASSERT_EQ(pairs.size(), 2u) << "neither of a parallel projection nor of one that looks straight up";
    const glm::dvec3 ahead = pairs[0].after.eye_world - camera.eye_world;
    const glm::dvec3 aside = pairs[1].after.eye_world - camera.eye_world;
    EXPECT_NEAR(ahead.z, -1.4 / 25.0, 1e-9);
    EXPECT_NEAR(glm::dot(ahead, aside), 0.0, 1e-12);
    EXPECT_NEAR(glm::length(aside), 1.4 / 25.0, 1e-9);
    for (const FramePair& pair : pairs) {
        const glm::dvec3 was = glm::normalize(pair.before.target_world - pair.before.eye_world);
        const glm::dvec3 is = glm::normalize(pair.after.target_world - pair.after.eye_world);
        EXPECT_DOUBLE_EQ(was.y, is.y);
        EXPECT_NEAR(std::acos(glm::dot(was, is)), 0.8 * 0.5 * 0.0174533, 1e-4) << "about the vertical";
    }
}
