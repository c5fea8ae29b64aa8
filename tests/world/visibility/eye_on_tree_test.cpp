// Eyes that stand exactly where the tree divides space: in the plane of a wall, on an edge of a door, on its corners.
#include <gtest/gtest.h>

#include "tests/world/scene_builder.hpp"

namespace hw {
namespace {

using test::compile;
using test::Compiled;
using test::SceneBuilder;

/// Two rooms with a wall of a single double-sided sheet at x = 0 and a door in it: |z| < 0.5, y < 2. In each stands a
/// box; a third box stands behind the wall, out of the door's way.
struct TwoRooms {
    Compiled compiled;
    ObjectId left = 0, right = 0, aside = 0;

    TwoRooms()
    {
        SceneBuilder builder;
        builder.box({-6, 0, -6}, {6, 3, 6}, true);
        const int sheet = SceneBuilder::kDouble;
        builder.quad({{{0, 0, -6}, {0, 3, -6}, {0, 3, -0.5}, {0, 0, -0.5}}}, sheet);
        builder.quad({{{0, 0, 0.5}, {0, 3, 0.5}, {0, 3, 6}, {0, 0, 6}}}, sheet);
        builder.quad({{{0, 2, -0.5}, {0, 3, -0.5}, {0, 3, 0.5}, {0, 2, 0.5}}}, sheet);
        left = builder.box({-4, 0.5, -0.3}, {-3.5, 1, 0.3}, false);
        right = builder.box({3.5, 0.5, -0.3}, {4, 1, 0.3}, false);
        aside = builder.box({0.5, 0.5, 5}, {1, 1, 5.5}, false);
        compiled = compile(builder.scene());
    }

    bool sees_within(const glm::dvec3& eye, double near_radius_m, ObjectId object) const
    {
        std::vector<std::uint8_t> visible;
        visible_chunks(compiled.visibility, eye, near_radius_m, visible);
        return visible[compiled.visibility.first_slot_of_object[object]] != 0;
    }
};

}  // namespace

TEST(eye_on_tree, in_the_plane_of_a_wall_within_its_door_it_sees_both_rooms)
{
    const TwoRooms rooms;
    for (const glm::dvec3& eye : {glm::dvec3(0, 1, 0), glm::dvec3(0, 0.25, -0.375), glm::dvec3(0, 1.9, 0.4)}) {
        EXPECT_TRUE(rooms.compiled.sees(eye, rooms.left));
        EXPECT_TRUE(rooms.compiled.sees(eye, rooms.right));
    }
}

TEST(eye_on_tree, on_an_edge_of_the_door_it_sees_both_rooms)
{
    const TwoRooms rooms;
    for (const glm::dvec3& eye : {glm::dvec3(0, 1, 0.5), glm::dvec3(0, 1, -0.5), glm::dvec3(0, 2, 0.125)}) {
        EXPECT_TRUE(rooms.compiled.sees(eye, rooms.left));
        EXPECT_TRUE(rooms.compiled.sees(eye, rooms.right));
    }
}

TEST(eye_on_tree, on_a_vertex_of_the_door_it_sees_both_rooms)
{
    const TwoRooms rooms;
    for (const glm::dvec3& eye :
         {glm::dvec3(0, 2, 0.5), glm::dvec3(0, 2, -0.5), glm::dvec3(0, 0, 0.5), glm::dvec3(0, 0, -0.5)}) {
        EXPECT_TRUE(rooms.compiled.sees(eye, rooms.left));
        EXPECT_TRUE(rooms.compiled.sees(eye, rooms.right));
    }
}

TEST(eye_on_tree, in_the_sheet_of_a_wall_the_near_plane_sees_both_sides_and_a_step_back_one)
{
    const TwoRooms rooms;
    EXPECT_TRUE(rooms.sees_within({0, 1, 3}, 0.1, rooms.aside));
    EXPECT_TRUE(rooms.sees_within({0, 1, 3}, 0.1, rooms.left));
    EXPECT_TRUE(rooms.sees_within({0.5, 1, 3}, 0.1, rooms.aside));
    EXPECT_FALSE(rooms.sees_within({-0.5, 1, 3}, 0.1, rooms.aside)) << "the scene must hide something";
}

TEST(eye_on_tree, a_hair_to_either_side_of_the_plane_it_sees_both_rooms_too)
{
    const TwoRooms rooms;
    for (const double hair : {1e-12, 1e-9, 1e-6}) {
        for (const double side : {-hair, hair}) {
            EXPECT_TRUE(rooms.compiled.sees({side, 1, 0.25}, rooms.left));
            EXPECT_TRUE(rooms.compiled.sees({side, 1, 0.25}, rooms.right));
        }
    }
}

}  // namespace hw
