#include "hatchway/world/collision/collision.hpp"
#include "hatchway/world/looks.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

#include "tests/world/scene_builder.hpp"

namespace hw {
namespace {

using test::SceneBuilder;

const Capsule kWalker{0.3, 1.8};

CollisionWorld wall_at_x_zero()
{
    SceneBuilder builder;
    builder.quad({{{0, -5, -5}, {0, 5, -5}, {0, 5, 5}, {0, -5, 5}}});
    return build_collision_world(builder.scene(), {});
}

TEST(collision, a_sweep_stops_a_skin_before_a_wall)
{
    const SweepHit hit = sweep_capsule(wall_at_x_zero(), {-2, 0, 0}, {2, 0, 0}, kWalker);
    ASSERT_TRUE(hit.is_hit);
    EXPECT_NEAR(hit.foot_world.x, -(kWalker.radius_m + kCollisionSkin), 1e-6);
    EXPECT_NEAR(hit.normal.x, -1.0, 1e-9);
}

TEST(collision, nothing_is_tunnelled_through_however_long_the_way)
{
    const CollisionWorld world = wall_at_x_zero();
    for (double reach = 1.0; reach < 1e7; reach *= 10.0) {
        const SweepHit hit = sweep_capsule(world, {-reach, 0, 0}, {reach, 0, 0}, kWalker);
        ASSERT_TRUE(hit.is_hit) << reach;
        EXPECT_LT(hit.foot_world.x, -kWalker.radius_m) << reach;
    }
}

TEST(collision, both_sides_of_a_triangle_stop)
{
    const SweepHit hit = sweep_capsule(wall_at_x_zero(), {2, 0, 0}, {-2, 0, 0}, kWalker);
    ASSERT_TRUE(hit.is_hit);
    EXPECT_GT(hit.foot_world.x, kWalker.radius_m);
}

TEST(collision, a_capsule_that_touches_may_leave_and_slide_but_not_go_deeper)
{
    const CollisionWorld world = wall_at_x_zero();
    const glm::dvec3 touching(-(kWalker.radius_m + 0.5 * kCollisionSkin), 0, 0);
    EXPECT_FALSE(sweep_capsule(world, touching, touching - glm::dvec3(1, 0, 0), kWalker).is_hit);
    EXPECT_FALSE(sweep_capsule(world, touching, touching + glm::dvec3(0, 0, 1), kWalker).is_hit);
    const SweepHit deeper = sweep_capsule(world, touching, touching + glm::dvec3(1, 0, 0), kWalker);
    ASSERT_TRUE(deeper.is_hit);
    EXPECT_EQ(deeper.fraction, 0.0);
}

TEST(collision, a_ceiling_and_a_floor_stop)
{
    SceneBuilder builder;
    builder.box({-5, 0, -5}, {5, 3, 5}, true);
    const CollisionWorld world = build_collision_world(builder.scene(), {});
    const SweepHit up = sweep_capsule(world, {0, 0.5, 0}, {0, 9, 0}, kWalker);
    ASSERT_TRUE(up.is_hit);
    EXPECT_NEAR(up.foot_world.y + kWalker.height_m, 3.0 - kCollisionSkin, 1e-5);
    const SweepHit down = sweep_capsule(world, {0, 0.5, 0}, {0, -9, 0}, kWalker);
    ASSERT_TRUE(down.is_hit);
    EXPECT_NEAR(down.foot_world.y, kCollisionSkin, 1e-5);
}

TEST(collision, a_thin_post_and_an_edge_stop)
{
    SceneBuilder builder;
    builder.box({-0.01, 0, -0.01}, {0.01, 3, 0.01}, false);
    const CollisionWorld world = build_collision_world(builder.scene(), {});
    const SweepHit hit = sweep_capsule(world, {-3, 0.1, 0.2}, {3, 0.1, 0.2}, kWalker);
    ASSERT_TRUE(hit.is_hit);
    EXPECT_NEAR(std::hypot(hit.foot_world.x - (-0.01), hit.foot_world.z - 0.01), kWalker.radius_m + kCollisionSkin,
                1e-4);
    EXPECT_FALSE(sweep_capsule(world, {-3, 0.1, 0.32}, {3, 0.1, 0.32}, kWalker).is_hit);
}

TEST(collision, what_does_not_collide_or_is_animated_takes_no_part)
{
    SceneBuilder builder;
    builder.box({-1, 0, -1}, {1, 2, 1}, false);
    builder.box({9, 0, -1}, {11, 2, 1}, false);
    builder.scene().nodes[1].is_animated = true;
    std::vector<ObjectLook> looks(2);
    looks[0].collides = false;
    EXPECT_TRUE(build_collision_world(builder.scene(), looks).triangles.empty());
}

TEST(collision, a_rule_of_the_level_opens_a_wall_and_a_later_one_closes_it)
{
    SceneBuilder builder;
    builder.quad({{{0, -5, -5}, {0, 5, -5}, {0, 5, 5}, {0, -5, 5}}});
    builder.quad({{{9, -5, -5}, {9, 5, -5}, {9, 5, 5}, {9, -5, 5}}});
    Level level;
    level.assign = {{.nodes = "n*", .collides = false}, {.nodes = "n1", .collides = true}};
    const CollisionWorld world = build_collision_world(builder.scene(), resolve_looks(level, builder.scene(), "plain"));
    const SweepHit hit = sweep_capsule(world, {-2, 0, 0}, {20, 0, 0}, kWalker);
    ASSERT_TRUE(hit.is_hit);
    EXPECT_EQ(hit.object, 1u);
    EXPECT_NEAR(hit.foot_world.x, 9.0 - kWalker.radius_m - kCollisionSkin, 1e-6);
}

TEST(collision, an_empty_world_stops_nothing)
{
    const CollisionWorld world;
    EXPECT_FALSE(sweep_capsule(world, {0, 0, 0}, {1, 1, 1}, kWalker).is_hit);
    EXPECT_FALSE(overlaps(world, {0, 0, 0}, kWalker));
    EXPECT_EQ(push_out(world, {0, 0, 0}, kWalker, 1.0), glm::dvec3(0.0));
}

TEST(collision, push_out_finds_the_free_side)
{
    const CollisionWorld world = wall_at_x_zero();
    EXPECT_TRUE(overlaps(world, {-0.1, 0, 0}, kWalker));
    const auto free = push_out(world, {-0.1, 0, 0}, kWalker, 2.0);
    ASSERT_TRUE(free);
    EXPECT_FALSE(overlaps(world, *free, kWalker));
    EXPECT_LT(free->x, -kWalker.radius_m);
    EXPECT_FALSE(push_out(world, {-0.1, 0, 0}, kWalker, 0.01));
}

TEST(collision, random_walks_in_a_closed_room_never_leave_it)
{
    SceneBuilder builder;
    builder.box({-3, 0, -3}, {3, 4, 3}, true);
    builder.box({-1, 0, -1}, {0, 1, 0}, false);
    builder.box({1, 0.5, 1}, {1.02, 2.5, 2}, false);
    const CollisionWorld world = build_collision_world(builder.scene(), {});
    std::mt19937 engine(3);
    std::uniform_real_distribution<double> step(-4.0, 4.0);
    glm::dvec3 foot(2, 0.5, -2);
    for (int i = 0; i < 20000; ++i) {
        foot =
            sweep_capsule(world, foot, foot + glm::dvec3(step(engine), step(engine), step(engine)), kWalker).foot_world;
        ASSERT_LT(std::abs(foot.x), 2.7) << i;
        ASSERT_LT(std::abs(foot.z), 2.7) << i;
        ASSERT_GE(foot.y, 0.0) << i;
        ASSERT_FALSE(overlaps(world, foot, kWalker)) << i;
    }
}

TEST(collision, triangles_without_area_are_left_out)
{
    SceneBuilder builder;
    builder.quad({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}});
    EXPECT_TRUE(build_collision_world(builder.scene(), {}).triangles.empty());
}

}  // namespace
}  // namespace hw
