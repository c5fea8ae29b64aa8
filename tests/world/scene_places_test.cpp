// Strays and things without end: where a scene lies when one measure does not fit all of it.
#include "hatchway/world/scene_places.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "hatchway/world/mesh_pieces.hpp"
#include "tests/world/scene_builder.hpp"

namespace {

using namespace hw::test;
using hw::Box;
using hw::ObjectId;
using hw::ScenePlaces;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

bool is_same(const Box& a, const Box& b)
{
    return a.min == b.min && a.max == b.max;
}

Box all_of(const std::vector<Box>& boxes)
{
    Box all;
    for (const Box& box : boxes) all.add(box);
    return all;
}

/// A house of three parts, 10 m wide.
class scene_places : public testing::Test {
 protected:
    scene_places()
    {
        builder_.box({0, 0, 0}, {6, 3, 4}, false);
        builder_.box({0, 3, 0}, {6, 5, 4}, false);
        builder_.box({6, 0, 0}, {10, 3, 4}, false);
    }
    ObjectId stray(const glm::dvec3& at) { return builder_.box(at, at + 0.5, false); }
    ScenePlaces places() { return hw::find_places(builder_.scene()); }
    /// All of the scene as one mesh.
    hw::MeshData joined()
    {
        hw::MeshData mesh;
        for (const hw::MeshData& part : builder_.scene().meshes) {
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
            for (const std::uint32_t index : part.indices) mesh.indices.push_back(first + index);
        }
        return mesh;
    }
    void ground(double half)
    {
        builder_.quad({glm::dvec3(-half, 0, half), {half, 0, half}, {half, 0, -half}, {-half, 0, -half}});
    }

    SceneBuilder builder_;
    const Box house_{{0, 0, 0}, {10, 5, 4}};
};

}  // namespace

TEST_F(scene_places, of_a_usual_scene_are_its_objects)
{
    stray({100, 0, 0});  // a garden shed
    const ScenePlaces found = places();
    EXPECT_THAT(found.boxes_world, SizeIs(4));
    EXPECT_TRUE(is_same(found.main_world, builder_.scene().bounds_world));
    EXPECT_THAT(found.strays, IsEmpty());
    EXPECT_FALSE(hw::stray_doubt(found, builder_.scene()));
}

TEST_F(scene_places, leave_out_strays_in_every_direction_and_at_every_distance)
{
    const std::vector<ObjectId> strays{stray({1e7, 0, 0}), stray({1e6, 0, 0}),    stray({0, -1e5, 0}),
                                       stray({0, 0, 1e4}), stray({-2e7, 0, 1e7}), stray({0, 1e9, 0})};
    for (int i = 0; i < 15; ++i) builder_.box({0, 0, 0}, {6, 3, 4}, false);
    const ScenePlaces found = places();
    EXPECT_TRUE(is_same(found.main_world, house_));
    EXPECT_EQ(found.strays, strays);
    EXPECT_TRUE(is_same(all_of(found.boxes_world), builder_.scene().bounds_world)) << "nothing is lost";
    EXPECT_THAT(*hw::stray_doubt(found, builder_.scene()), HasSubstr("\"n3\" and 5 objects more lie far away"));
}

TEST_F(scene_places, of_a_georeferenced_model_with_a_point_left_at_the_origin_are_with_the_model)
{
    SceneBuilder builder;
    builder.box({0, 0, 0}, {0.5, 0.5, 0.5}, false);
    for (int i = 0; i < 4; ++i) builder.box({4e5 + 4 * i, 0, 5e6}, {4e5 + 4 * i + 4, 3, 5e6 + 4}, false);
    const ScenePlaces found = hw::find_places(builder.scene());
    EXPECT_EQ(found.main_world.min.x, 4e5);
    EXPECT_THAT(found.strays, ElementsAre(0u));
    EXPECT_THAT(*hw::stray_doubt(found, builder.scene()), HasSubstr("\"n0\" lies, or has a part, far away"));
}

TEST_F(scene_places, two_equal_halves_far_apart_are_both_meant)
{
    for (int i = 0; i < 3; ++i) builder_.box({1e6 + i, 0, 0}, {1e6 + i + 1, 1, 1}, false);
    const ScenePlaces found = places();
    EXPECT_TRUE(is_same(found.main_world, builder_.scene().bounds_world));
    EXPECT_THAT(found.strays, IsEmpty());
}

TEST_F(scene_places, look_into_a_mesh_that_has_a_stray_part)
{
    const hw::MeshData house = joined();
    stray({1e7, 0, 0});
    stray({0, -1e5, 1e6});
    for (int i = 0; i < 4; ++i) builder_.box({0, 0, 0}, {6, 3, 4}, false);
    SceneBuilder one;
    one.add(joined(), SceneBuilder::kSingle);
    const ScenePlaces found = hw::find_places(one.scene());
    EXPECT_TRUE(is_same(found.main_world, house_));
    EXPECT_THAT(found.strays, ElementsAre(0u));
    EXPECT_THAT(hw::mesh_pieces(house), SizeIs(1));
}

TEST_F(scene_places, a_ground_without_end_is_no_stray_and_not_what_a_picture_of_the_whole_is_made_for)
{
    ground(1e6);
    const ScenePlaces found = places();
    EXPECT_TRUE(is_same(found.main_world, house_));
    EXPECT_THAT(found.strays, IsEmpty()) << "it is where the house is";
}

TEST_F(scene_places, a_ground_without_end_in_the_mesh_of_what_stands_on_it_is_a_part_of_its_own)
{
    ground(1e5);
    const std::vector<hw::MeshPiece> parts = hw::mesh_pieces(joined());
    ASSERT_THAT(parts, SizeIs(2));
    EXPECT_TRUE(is_same(parts[0].bounds, house_));
    EXPECT_EQ(parts[1].triangles, 2u);
}

TEST_F(scene_places, around_an_eye_are_what_lies_together_there)
{
    const glm::dvec3 there(1e6, 0, 0);
    for (int i = 0; i < 3; ++i) builder_.box(there + glm::dvec3(i), there + glm::dvec3(i + 1), false);
    stray({0, 1e5, 0});
    ground(1e7);
    const ScenePlaces found = places();
    EXPECT_TRUE(is_same(hw::place_around(found, {5, 2, 2}), house_));
    EXPECT_TRUE(is_same(hw::place_around(found, {5, 2, 5000}), house_)) << "from afar";
    EXPECT_TRUE(is_same(hw::place_around(found, there - 3.0), {there, there + 3.0}));
}

TEST_F(scene_places, around_an_eye_beside_a_trifle_are_all)
{
    for (int i = 0; i < 50; ++i) builder_.box({5, 2, 2}, {5.01, 2.01, 2.01}, false);
    EXPECT_TRUE(is_same(hw::place_around(places(), {5, 2, 2.001}), house_));
    EXPECT_TRUE(is_same(places().main_world, house_)) << "most triangles are the trifle's";
}

TEST(scene_places_of_nothing, are_none)
{
    const ScenePlaces found = hw::find_places(hw::Scene());
    EXPECT_TRUE(found.boxes_world.empty());
    EXPECT_TRUE(found.main_world.is_empty());
}

TEST(end_of_group, is_before_the_first_gap_in_any_order)
{
    const std::array values{5000.0, 3.0, 40.0, 0.0, 1.0, 4900.0};
    EXPECT_EQ(hw::end_of_group(values, 0.0, 30.0), 40.0);
    EXPECT_EQ(hw::end_of_group(values, 40.0, 30.0), 5000.0);
    EXPECT_EQ(hw::end_of_group(values, 5000.0, 30.0), 5000.0);
    EXPECT_EQ(hw::end_of_group({}, 0.0, 30.0), 0.0);
}
