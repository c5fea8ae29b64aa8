// The measure of walking must tell what is wrong: broken walkers, each with a count that is known.
#include <gtest/gtest.h>

#include <cmath>

#include "measure/walk/walk_fuzz.hpp"
#include "tests/walk/solids.hpp"
#include "tests/world/scene_builder.hpp"

namespace {

using hw::PlayerInput;
using hw::PlayerState;
using hw::measure::JudgedBody;
using hw::measure::WalkCounts;
using hw::measure::WalkOracle;
using hw::test::SceneBuilder;

const hw::PlayerBody kBody;
const JudgedBody kJudged;

std::array<glm::dvec3, 4> level_square(double half, double y)
{
    return {{{-half, y, -half}, {-half, y, half}, {half, y, half}, {half, y, -half}}};
}

std::array<glm::dvec3, 4> upright_square(double half, double x)
{
    return {{{x, -half, -half}, {x, half, -half}, {x, half, half}, {x, -half, half}}};
}

PlayerState at(const glm::dvec3& foot)
{
    PlayerState state;
    state.foot_world = state.last_foot_world = state.safe_foot_world = foot;
    state.is_carried = true;
    return state;
}

WalkCounts counts_of(const hw::Scene& scene, const hw::measure::Walker& walker, std::uint64_t inputs,
                     const glm::dvec3& foot = {0.3, 0.002, 0.1}, std::uint32_t threads = 0)
{
    const PlayerState start = at(foot);
    return fuzz_walk(WalkOracle(scene, {}), walker, kBody, {&start, 1},
                     {.inputs = inputs, .walks = 4, .flying = 0, .threads = threads});
}

/// Walks by hw::step() in a world without the objects of these numbers.
hw::measure::Walker walker_without(const hw::Scene& scene, std::initializer_list<hw::ObjectId> unseen)
{
    std::vector<hw::ObjectLook> looks(scene.objects.size());
    for (const hw::ObjectId id : unseen) looks[id].collides = false;
    return [world = build_collision_world(scene, looks)](const PlayerState& state, const PlayerInput& input,
                                                         double seconds) {
        return hw::step(state, input, kBody, world, seconds);
    };
}

/// Goes along x at 1 m/s whatever is asked of it.
PlayerState ghost(const PlayerState& state, const PlayerInput&, double seconds)
{
    PlayerState next = state;
    next.foot_world.x += seconds;
    next.last_foot_world = next.foot_world;
    return next;
}

}  // namespace

TEST(walk_oracle, tells_how_deep_a_body_reaches_into_a_wall_an_edge_and_a_corner)
{
    SceneBuilder builder;
    builder.quad(upright_square(5, 0.0));
    builder.box({10, -1, -1}, {12, 1, 1}, false);
    const WalkOracle oracle(builder.scene(), {});
    EXPECT_NEAR(oracle.depth({-0.295, 0, 0}, kJudged), 0.005, 1e-12);
    EXPECT_NEAR(oracle.depth({0.1, 0, 0}, kJudged), 0.2, 1e-12);
    EXPECT_LE(oracle.depth({-0.301, 0, 0}, kJudged), 0.0);
    EXPECT_NEAR(oracle.depth({10.0 - 0.2, 0.0, 1.0 + 0.2}, kJudged), 0.3 - 0.2 * std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(oracle.depth({10.0 - 0.1, 0.9, 1.0 + 0.1}, kJudged), 0.3 - std::sqrt(0.01 + 0.01 + 0.04), 1e-12);
    EXPECT_EQ(oracle.depth({11, 0.5, 0}, kJudged), 0.3) << "the axis meets the top";
}

TEST(walk_oracle, tells_a_way_through_a_face_from_one_round_it_and_from_a_step)
{
    SceneBuilder builder;
    builder.quad({{{0, 0, -5}, {0, 3, -5}, {0, 3, 0}, {0, 0, 0}}});
    builder.box({9.3, -1, -1}, {12, 0.34, 1}, false);
    const WalkOracle oracle(builder.scene(), {});
    const auto normal = oracle.crossed({-1, 0, -2}, {1, 0.2, -2.3}, kJudged);
    ASSERT_TRUE(normal);
    EXPECT_NEAR(std::abs(normal->x), 1.0, 1e-12);
    EXPECT_FALSE(oracle.crossed({-1, 0, 0.4}, {1, 0, 0.4}, kJudged));
    EXPECT_FALSE(oracle.crossed({9.0, 0, 0}, {9.5, 0.34, 0}, kJudged));
    EXPECT_TRUE(oracle.crossed({10, 1, 0}, {10, -4, 0}, kJudged)) << "down through the top";
    EXPECT_TRUE(oracle.has_ground_below({10, 1, 0}));
    EXPECT_FALSE(oracle.has_ground_below({5, 1, 0}));
}

TEST(walk_oracle, chooses_places_on_floors_outside_of_solids)
{
    SceneBuilder builder;
    builder.box({-6, 0, -6}, {6, 3, 6}, true);
    builder.box({-3, 0, -3}, {3, 2.9, 3}, false);
    const auto places = WalkOracle(builder.scene(), {}).standing_places(kJudged, 50, 1);
    ASSERT_EQ(places.size(), 50u);
    for (const glm::dvec3& foot : places) {
        EXPECT_NEAR(foot.y, 0.003, 1e-9);
        EXPECT_GT(std::max(std::abs(foot.x), std::abs(foot.z)), 3.0);
    }
}

TEST(walk_measure, a_walker_that_does_nothing_wrong_counts_nothing)
{
    SceneBuilder builder;
    builder.box({-6, 0, -6}, {6, 3, 6}, true);
    builder.box({-2, 0, -2}, {-1, 0.3, 1}, false);
    builder.box({2, 0, -2}, {2.1, 2.5, 3}, false);
    const WalkCounts counts = counts_of(builder.scene(), walker_without(builder.scene(), {}), 4000);
    EXPECT_EQ(counts.inputs, 4000u);
    EXPECT_EQ(counts.wrong(), 0u);
    EXPECT_EQ(counts.put_back, 0u);
    EXPECT_LE(counts.worst_depth_m, 0.0);
    EXPECT_GT(counts.cells, 100u);
}

TEST(walk_measure, each_walk_falls_once_through_a_floor_that_does_not_collide)
{
    SceneBuilder builder;
    const auto floor = builder.quad(level_square(1000, 0.0));
    builder.quad(level_square(1000, -6.0));
    const WalkCounts counts = counts_of(builder.scene(), walker_without(builder.scene(), {floor}), 4000);
    EXPECT_EQ(counts.floors_crossed, 4u);
    EXPECT_EQ(counts.walls_crossed, 0u);
    EXPECT_GT(counts.penetrations, 4u);
    EXPECT_NEAR(counts.worst_depth_m, 0.3, 1e-12);
}

TEST(walk_measure, a_ghost_is_counted_in_each_of_ten_walls)
{
    SceneBuilder builder;
    builder.quad(level_square(1000, -1.0));
    for (int wall = 1; wall <= 10; ++wall) builder.quad(upright_square(5, wall));
    const WalkCounts counts = counts_of(builder.scene(), ghost, 4000);
    ASSERT_GT(counts.walked_s, 4 * 11.0);
    EXPECT_EQ(counts.walls_crossed, 40u);
    EXPECT_EQ(counts.floors_crossed, 0u);
}

TEST(walk_measure, a_walker_that_sinks_5_mm_into_the_floor_is_counted_in_every_frame)
{
    SceneBuilder builder;
    builder.quad(level_square(1000, 0.0));
    const WalkCounts counts = counts_of(builder.scene(), ghost, 500, {0.3, -0.005, 0.1});
    EXPECT_EQ(counts.penetrations, counts.frames);
    EXPECT_NEAR(counts.worst_depth_m, 0.005, 1e-12);
    EXPECT_EQ(counts.wrong(), counts.penetrations);
}

TEST(walk_measure, a_walker_that_is_thrown_once_or_put_back_without_need_is_counted_once)
{
    SceneBuilder builder;
    builder.quad(level_square(1000, 0.0));
    for (const std::uint32_t told : {0u, 1u}) {
        const auto thrown = [told](const PlayerState& state, const PlayerInput&, double) {
            PlayerState next = state;
            if (state.foot_world.x < 1.0) next.put_back_count += told;
            if (state.foot_world.x < 1.0) next.foot_world.x += 40.0;
            return next;
        };
        const WalkCounts counts = counts_of(builder.scene(), thrown, 400);
        EXPECT_EQ(counts.thrown, 4u);
        EXPECT_EQ(counts.wrong(), 4u) << "told to have been put back: " << told;
    }
}

TEST(walk_measure, a_walker_on_a_plate_in_the_void_stays_on_it)
{
    SceneBuilder builder;
    builder.quad(level_square(2, 0.0));
    const WalkCounts counts = counts_of(builder.scene(), walker_without(builder.scene(), {}), 4000);
    EXPECT_GT(counts.cells, 40u);
    EXPECT_EQ(counts.wrong(), 0u);
}

TEST(walk_measure, who_falls_into_the_void_and_is_put_back_or_flies_is_counted_each_time)
{
    SceneBuilder builder;
    builder.quad(level_square(2, 0.0));
    for (const bool flies : {false, true}) {
        const auto falling = [flies](const PlayerState& state, const PlayerInput&, double seconds) {
            PlayerState next = state;
            next.foot_world.x += seconds;
            if (next.foot_world.x < 3.0) return next;
            next.foot_world.x = 0.3;
            if (flies) next.is_flying = true;
            if (!flies) ++next.put_back_count;
            return next;
        };
        const WalkCounts counts = counts_of(builder.scene(), falling, 400);
        EXPECT_GT(flies ? counts.lost : counts.put_back, 4u);
        EXPECT_GE(counts.wrong(), counts.lost + counts.put_back);
    }
}

TEST(walk_measure, a_walker_that_never_moves_is_stuck_once_in_half_a_minute)
{
    SceneBuilder builder;
    builder.quad(level_square(1000, 0.0));
    const auto post = [](const PlayerState& state, const PlayerInput&, double) { return state; };
    const WalkCounts counts = counts_of(builder.scene(), post, 3200);
    ASSERT_GT(counts.walked_s, 4 * 31.0);
    ASSERT_LT(counts.walked_s, 4 * 59.0);
    EXPECT_EQ(counts.stuck, 4u);
}

TEST(walk_measure, an_eye_above_the_ceiling_is_counted_in_every_frame)
{
    SceneBuilder builder;
    builder.box({-500, 0, -500}, {500, 2, 500}, true);
    const auto tall = [](const PlayerState& state, const PlayerInput&, double) {
        PlayerState next = state;
        next.eye_offset_m = 0.4;
        return next;
    };
    const WalkCounts counts = counts_of(builder.scene(), tall, 200);
    EXPECT_EQ(counts.eyes_parted, counts.frames);
}

TEST(walk_measure, counts_do_not_depend_on_threads)
{
    SceneBuilder builder;
    builder.box({-6, 0, -6}, {6, 3, 6}, true);
    const auto floor = builder.quad(level_square(5, 0.5));
    const auto walker = walker_without(builder.scene(), {floor});
    const WalkCounts alone = counts_of(builder.scene(), walker, 1000, {0.3, 0.002, 0.1}, 1);
    const WalkCounts all = counts_of(builder.scene(), walker, 1000, {0.3, 0.002, 0.1}, 3);
    EXPECT_EQ(alone.way_m, all.way_m);
    EXPECT_EQ(alone.cells, all.cells);
    EXPECT_EQ(alone.wrong(), all.wrong());
}
