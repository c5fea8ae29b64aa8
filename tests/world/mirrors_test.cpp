// Which objects are mirrors, and their planes.
#include <gmock/gmock.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "hatchway/core/error.hpp"
#include "hatchway/world/mirrors.hpp"
#include "tests/world/scene_builder.hpp"

namespace hw::test {
namespace {

Level level_of(std::vector<MirrorRule> rules)
{
    Level level;
    level.file = "a.level.json";
    level.mirrors = std::move(rules);
    for (std::size_t i = 0; i < level.mirrors.size(); ++i) level.mirrors[i].pointer = fmt::format("/mirrors/{}", i);
    return level;
}

std::string refusal_of(const Level& level, const Scene& scene)
{
    try {
        find_mirrors(level, scene);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

Scene pane()
{
    SceneBuilder builder;
    builder.quad({glm::dvec3(0, 0, 2), {2, 0, 0}, {2, 3, 0}, {0, 3, 2}});
    return builder.scene();
}

TEST(mirrors, have_the_plane_of_their_faces_its_front_where_they_are_drawn)
{
    const std::vector<Mirror> mirrors = find_mirrors(level_of({{"n0"}}), pane());
    ASSERT_EQ(mirrors.size(), 1u);
    const MirrorPlane& plane = mirrors[0].plane;
    const double half = std::sqrt(0.5);
    EXPECT_LT(glm::length(plane.normal_world - glm::dvec3(half, 0, half)), 1e-12);
    EXPECT_NEAR(plane.offset_m, 2.0 * half, 1e-12);
    EXPECT_NEAR(plane.height({2, 7, 2}), 2.0 * half, 1e-12);
    EXPECT_LT(glm::length(plane.reflected({2, 7, 2}) - glm::dvec3(0, 7, 0)), 1e-12);
    EXPECT_LT(glm::length(plane.turned().reflected({2, 7, 2}) - glm::dvec3(0, 7, 0)), 1e-12);
    EXPECT_LT(plane.turned().height({2, 7, 2}), 0.0);
    EXPECT_EQ(mirrors[0].outline_world.size(), 4u);
    EXPECT_FALSE(mirrors[0].is_two_sided);
}

TEST(mirrors, follow_their_nodes_also_through_transforms_that_mirror)
{
    Scene scene = pane();
    scene.nodes[0].world_from_node = glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, 1.0, -1.0));
    const std::vector<Mirror> mirrors = find_mirrors(level_of({{"n0"}}), scene);
    const double half = std::sqrt(0.5);
    EXPECT_LT(glm::length(mirrors[0].plane.normal_world - glm::dvec3(half, 0, -half)), 1e-12)
        << "what winds the other way by the transform is drawn from where it was";
}

TEST(mirrors, have_the_outline_of_their_convex_hull)
{
    SceneBuilder builder;
    MeshData fan;
    constexpr int kSides = 7;
    for (int i = 0; i < kSides; ++i)
        fan.positions.emplace_back(std::cos(2 * M_PI * i / kSides), 0.0f, std::sin(2 * M_PI * i / kSides));
    fan.positions.emplace_back(0.1f, 0.0f, 0.1f);
    for (std::uint32_t i = 0; i < kSides; ++i) fan.indices.insert(fan.indices.end(), {kSides, (i + 1) % kSides, i});
    builder.add(fan, SceneBuilder::kSingle);
    const std::vector<Mirror> mirrors = find_mirrors(level_of({{"*"}}), builder.scene());
    ASSERT_EQ(mirrors.size(), 1u);
    EXPECT_EQ(mirrors[0].outline_world.size(), static_cast<std::size_t>(kSides));
    EXPECT_GT(mirrors[0].plane.normal_world.y, 0.999);
}

TEST(mirrors, of_two_rules_for_an_object_the_later_one_wins_and_children_are_reached)
{
    SceneBuilder builder;
    for (int i = 0; i < 3; ++i) builder.quad({glm::dvec3(i, 0, 0), {i + 1, 0, 0}, {i + 1, 1, 0}, {i, 1, 0}});
    Scene scene = builder.scene();
    scene.nodes[2].parent = 1;
    const std::vector<Mirror> mirrors = find_mirrors(level_of({{"*", 0.25}, {"#1", 0.5}}), scene);
    ASSERT_EQ(mirrors.size(), 3u);
    EXPECT_EQ(mirrors[0].reflectance, 0.25f);
    EXPECT_EQ(mirrors[1].reflectance, 0.5f);
    EXPECT_EQ(mirrors[2].reflectance, 0.5f);
}

TEST(mirrors, are_refused_where_no_node_is_named_or_one_is_not_flat)
{
    SceneBuilder builder;
    builder.quad({glm::dvec3(0, 0, 0), {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    builder.box({0, 0, 0}, {1, 1, 1}, false);
    builder.quad({glm::dvec3(0, 0, 0), {1, 0, 0}, {1, 1, 0.01}, {0, 1, 0}});
    const Scene& scene = builder.scene();
    EXPECT_EQ(refusal_of(level_of({{"n0"}}), scene), "");
    EXPECT_THAT(
        refusal_of(level_of({{"n0"}, {"nowhere"}}), scene),
        testing::AllOf(testing::HasSubstr("/mirrors/1/nodes"), testing::HasSubstr("\"nowhere\" names no node")));
    EXPECT_THAT(refusal_of(level_of({{"n1"}}), scene),
                testing::AllOf(testing::HasSubstr("/mirrors/0/nodes"), testing::HasSubstr("\"n1\" is not flat")));
    EXPECT_THAT(refusal_of(level_of({{"#2"}}), scene), testing::HasSubstr("\"n2\" is not flat"));
}

TEST(mirrors, are_none_where_there_are_no_faces_and_two_sided_where_faces_look_both_ways)
{
    SceneBuilder builder;
    builder.add({}, SceneBuilder::kSingle);
    MeshData line;
    line.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    line.indices = {0, 1, 2};
    builder.add(line, SceneBuilder::kSingle);
    MeshData both;
    both.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    both.indices = {0, 1, 2, 0, 3, 2};
    builder.add(both, SceneBuilder::kSingle);
    builder.quad({glm::dvec3(0, 0, 0), {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, SceneBuilder::kDouble);
    const std::vector<Mirror> mirrors = find_mirrors(level_of({{"*"}}), builder.scene());
    ASSERT_EQ(mirrors.size(), 2u);
    EXPECT_TRUE(mirrors[0].is_two_sided);
    EXPECT_TRUE(mirrors[1].is_two_sided);
}

}  // namespace
}  // namespace hw::test
