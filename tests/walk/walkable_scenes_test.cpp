// A fuzzed walk in real scenes. Each tick is checked by a way that the walk itself does not use: the middle of the body
// never crosses a triangle.
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "hatchway/io/gltf/import.hpp"
#include "hatchway/walk/player.hpp"
#include "tests/shared_data.hpp"

namespace {

namespace fs = std::filesystem;

const hw::PlayerBody kBody;
constexpr int kTicksPerInput = 30;

struct Place {
    std::string file;
    glm::dvec3 eye;
};

hw::PlayerInput random_input(std::mt19937& random)
{
    const auto axis = [&] { return static_cast<double>(random() % 3) - 1.0; };
    hw::PlayerInput input{.forward = random() % 4 == 0 ? axis() : 1.0, .right = axis(), .turn_left = axis()};
    input.look_left_rad = random() % 2000 / 1000.0 - 1.0;
    input.is_fast = random() % 2 == 0;
    input.wants_jump = random() % 4 == 0;
    input.speed_factor = random() % 16 == 0 ? 10.0 : 1.0;
    return input;
}

bool crosses_a_triangle(const hw::CollisionWorld& world, const glm::dvec3& from, const glm::dvec3& to)
{
    const glm::dvec3 middle(0.0, 0.5 * kBody.gait.capsule.height_m, 0.0);
    const hw::Capsule point{.radius_m = 1e-4, .height_m = 2e-4};
    const hw::SweepHit hit = hw::sweep_capsule(world, from + middle, to + middle, point);
    return hit.is_hit && hit.fraction < 0.999;
}

class WalkableScene : public testing::TestWithParam<Place> {
 protected:
    void SetUp() override
    {
        const fs::path file = fs::path(HATCHWAY_SOURCE_DIR) / GetParam().file;
        HATCHWAY_NEEDS_DATA(fs::exists(file), file);
        scene_ = hw::import_gltf(file, file.parent_path());
        world_ = hw::build_collision_world(scene_, {});
    }

    hw::PlayerState start() const
    {
        const glm::dvec3 eye = GetParam().eye;
        hw::PlayerState state =
            hw::placed_at({.eye_world = eye, .target_world = eye + glm::dvec3(0, 0, -1)}, kBody, world_);
        state.is_flying = false;
        return state;
    }

    hw::Scene scene_;
    hw::CollisionWorld world_;
};

}  // namespace

TEST_P(WalkableScene, a_random_walk_crosses_no_wall_and_does_not_fall_out_of_the_world)
{
    std::mt19937 random(7);
    hw::PlayerState state = start();
    for (int round = 0; round < 600; ++round) {
        hw::PlayerInput input = random_input(random);
        for (int tick = 0; tick < kTicksPerInput; ++tick) {
            const hw::PlayerState next = hw::step(state, input, kBody, world_, hw::kPlayerTick_s);
            input.look_left_rad = 0.0;
            ASSERT_LT(glm::distance(next.foot_world, state.foot_world), 1.0) << "thrown back, so it had fallen";
            ASSERT_FALSE(crosses_a_triangle(world_, state.foot_world, next.foot_world))
                << "round " << round << " near " << state.foot_world.x << ' ' << state.foot_world.y << ' '
                << state.foot_world.z;
            state = next;
        }
    }
}

TEST_P(WalkableScene, a_random_walk_gets_on_from_everywhere)
{
    std::mt19937 random(8);
    hw::PlayerState state = start();
    glm::dvec3 anchor = state.foot_world;
    int rounds_here = 0, longest = 0;
    for (int round = 0; round < 1200; ++round) {
        const hw::PlayerInput input = random_input(random);
        const double frame_s = std::pow(10.0, -1.0 - random() % 1000 / 500.0);
        for (double time_s = 0.0; time_s < 0.25; time_s += frame_s)
            state = hw::step(state, input, kBody, world_, frame_s);
        longest = std::max(longest, ++rounds_here);
        if (glm::distance(state.foot_world, anchor) < 0.5) continue;
        anchor = state.foot_world;
        rounds_here = 0;
    }
    EXPECT_LT(longest, 60) << "a quarter of a minute on one spot";
}

TEST(walkable_hall, leads_through_the_court_up_the_stair_to_the_gallery_and_into_the_side_room)
{
    const fs::path file = fs::path(HATCHWAY_SOURCE_DIR) / "content/models/hall.glb";
    const hw::Scene scene = hw::import_gltf(file, file.parent_path());
    const hw::CollisionWorld world = hw::build_collision_world(scene, {});
    hw::PlayerState state = hw::placed_at({.eye_world = {0, 1.7, 9.6}, .target_world = {0, 1.7, 0}}, kBody, world);
    const glm::dvec3 way[] = {{0, 0, -5},       {0.7, 0, -0.9}, {5, 0, 0},       {10.8, -0.1, 0.4}, {3, 0, 0},
                              {-5.3, 0, 0.5},   {-5.3, 1.8, 6}, {-4, 3.24, 8.7}, {4, 3.24, 8.9},    {-4, 3.24, 8.9},
                              {-5.3, 2.2, 6.3}, {-5.3, 0, 0.5}, {-3.9, 0, -5.6}, {-9, 0, -4.5}};
    for (const glm::dvec3& place : way) {
        glm::dvec3 left = place - state.foot_world;
        for (int tick = 0; tick < 1400 && std::hypot(left.x, left.z) > 0.3; ++tick) {
            state.yaw_rad = state.last_yaw_rad = std::atan2(-left.x, -left.z);
            state = hw::step(state, {.forward = 1.0}, kBody, world, hw::kPlayerTick_s);
            left = place - state.foot_world;
        }
        ASSERT_LT(std::hypot(left.x, left.z), 0.31) << "on the way to " << place.x << ' ' << place.z;
        ASSERT_LT(std::abs(left.y), 0.3) << "at " << place.x << ' ' << place.z;
    }
}

INSTANTIATE_TEST_SUITE_P(scenes, WalkableScene,
                         testing::Values(Place{"content/models/hall.glb", {0, 1.7, 9.6}},
                                         Place{"../shared/data/scenes/dungeon_kaykit_9x7.glb", {16, 2, 12}},
                                         Place{"../shared/data/scenes/oa_oa_dm1.glb", {7, 0, -34}}),
                         [](const testing::TestParamInfo<Place>& scene) {
                             std::string name = fs::path(scene.param.file).stem().string();
                             return name;
                         });
