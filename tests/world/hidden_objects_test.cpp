#include "hatchway/world/hidden_objects.hpp"

#include <gtest/gtest.h>

#include "hatchway/world/collision/collision.hpp"
#include "hatchway/world/visibility/visibility.hpp"
#include "tests/world/scene_builder.hpp"

namespace hw::test {
namespace {

std::vector<ObjectLook> hiding(const Scene& scene, std::vector<ObjectId> ids)
{
    std::vector<ObjectLook> looks(scene.objects.size());
    for (const ObjectId id : ids) looks[id].is_visible = false;
    return looks;
}

/// Two rooms with a wall between, and a ball's box in each.
struct TwoRooms {
    TwoRooms()
    {
        builder.box({-10, 0, -5}, {10, 4, 5}, true);
        wall = builder.box({-0.2, 0, -5}, {0.2, 4, 5}, false);
        left = builder.box({-6, 0, -1}, {-5, 1, 1}, false);
        right = builder.box({5, 0, -1}, {6, 1, 1}, false);
    }
    bool sees_right_from_left(Scene& scene) const
    {
        Level level;
        level.structure = std::vector<std::string>{"n0", "n1"};
        return compile(scene, {}, level).sees({-8, 2, 3}, right);
    }
    SceneBuilder builder;
    ObjectId wall = 0, left = 0, right = 0;
};

TEST(hidden_objects, leave_nothing_and_come_back_as_they_were)
{
    TwoRooms rooms;
    Scene scene = rooms.builder.scene();
    const Scene before = scene;
    EXPECT_FALSE(hide_objects(scene, hiding(scene, {})));
    EXPECT_TRUE(hide_objects(scene, hiding(scene, {0, rooms.left})));
    EXPECT_FALSE(hide_objects(scene, hiding(scene, {0, rooms.left}))) << "nothing new";
    EXPECT_EQ(hidden_objects(scene), (std::vector<ObjectId>{0, rooms.left}));
    EXPECT_EQ(scene.objects.size(), before.objects.size()) << "numbers stay";
    EXPECT_EQ(drawn_triangle_count(scene), drawn_triangle_count(before) - 24);
    EXPECT_FLOAT_EQ(static_cast<float>(scene.bounds_world.min.x), -0.2f) << "what is hidden has no extent";
    for (const CollisionWorld::Triangle& triangle : build_collision_world(scene, {}).triangles)
        EXPECT_TRUE(triangle.object == rooms.wall || triangle.object == rooms.right);

    EXPECT_TRUE(hide_objects(scene, hiding(scene, {rooms.wall})));
    EXPECT_EQ(hidden_objects(scene), std::vector<ObjectId>{rooms.wall});
    EXPECT_TRUE(hide_objects(scene, {}));
    EXPECT_EQ(scene.meshes.size(), before.meshes.size());
    EXPECT_EQ(scene.bounds_world.min, before.bounds_world.min);
    for (ObjectId id = 0; id < scene.objects.size(); ++id) EXPECT_EQ(scene.objects[id].mesh, before.objects[id].mesh);
}

TEST(hidden_objects, block_no_sight)
{
    TwoRooms rooms;
    Scene scene = rooms.builder.scene();
    EXPECT_FALSE(rooms.sees_right_from_left(scene));
    hide_objects(scene, hiding(scene, {rooms.wall}));
    EXPECT_TRUE(rooms.sees_right_from_left(scene));
}

TEST(hidden_objects, may_be_all_there_are)
{
    TwoRooms rooms;
    Scene scene = rooms.builder.scene();
    hide_objects(scene, hiding(scene, {0, 1, 2, 3}));
    EXPECT_TRUE(scene.bounds_world.is_empty());
    EXPECT_EQ(drawn_triangle_count(scene), 0u);
    EXPECT_TRUE(build_collision_world(scene, {}).triangles.empty());
}

TEST(looks, a_rule_says_what_is_visible_and_the_last_wins)
{
    TwoRooms rooms;
    Level level;
    level.assign = {{.nodes = "*", .visible = false, .pointer = "/assign/0"},
                    {.nodes = "n2", .visible = true, .pointer = "/assign/1"}};
    const auto looks = resolve_looks(level, rooms.builder.scene(), "photoreal");
    EXPECT_FALSE(looks[1].is_visible);
    EXPECT_EQ(looks[1].visible_pointer, "/assign/0/visible");
    EXPECT_TRUE(looks[2].is_visible);
    EXPECT_EQ(looks[2].visible_pointer, "/assign/1/visible");
}

}  // namespace
}  // namespace hw::test
