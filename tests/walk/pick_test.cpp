#include "hatchway/walk/pick.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

namespace {

const glm::dvec3 kAhead(0, 0, -1);

/// Sheets of 2 x 2 m that face +z, one object each, at the given places.
hw::Scene sheets(const std::vector<glm::dmat4>& places)
{
    hw::Scene scene;
    hw::MeshData sheet;
    sheet.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    sheet.indices = {0, 1, 2, 0, 2, 3};
    scene.meshes = {sheet};
    scene.materials.resize(1);
    for (const glm::dmat4& place : places) {
        scene.nodes.push_back({.world_from_node = place});
        scene.objects.push_back({.node = static_cast<int>(scene.nodes.size()) - 1, .mesh = 0, .material = 0});
    }
    return scene;
}

glm::dmat4 at(double x, double y, double z)
{
    return glm::translate(glm::dmat4(1.0), {x, y, z});
}

}  // namespace

TEST(pick, finds_the_nearest_of_several)
{
    const hw::Scene scene = sheets({at(0, 0, -5), at(0, 0, -3), at(0, 0, -8), at(0, 0, 3)});
    const auto hit = hw::pick(hw::build_pick_world(scene), {0.2, 0.1, 0}, kAhead);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->object, 1u);
    EXPECT_DOUBLE_EQ(hit->distance_m, 3.0);
}

TEST(pick, misses_what_is_beside_or_behind)
{
    const hw::Scene scene = sheets({at(5, 0, -5), at(0, 0, 3)});
    EXPECT_FALSE(hw::pick(hw::build_pick_world(scene), {0, 0, 0}, kAhead));
    EXPECT_FALSE(hw::pick(hw::build_pick_world(hw::Scene{}), {0, 0, 0}, kAhead));
}

TEST(pick, looks_through_the_back_of_a_single_sided_sheet_but_not_of_a_double_sided_one)
{
    hw::Scene scene = sheets({at(0, 0, 3), at(0, 0, 5)});
    EXPECT_FALSE(hw::pick(hw::build_pick_world(scene), {0, 0, 0}, -kAhead));
    scene.materials[0].is_double_sided = true;
    EXPECT_EQ(hw::pick(hw::build_pick_world(scene), {0, 0, 0}, -kAhead)->object, 0u);
}

TEST(pick, a_mirrored_object_is_drawn_from_its_mirrored_front)
{
    const hw::Scene scene = sheets({at(0, 0, -3) * glm::scale(glm::dmat4(1.0), {-1, 1, 1})});
    EXPECT_TRUE(hw::pick(hw::build_pick_world(scene), {0, 0, 0}, kAhead));
}

TEST(pick, finds_animated_objects_too)
{
    hw::Scene scene = sheets({at(0, 0, -5), at(0, 0, -3)});
    scene.nodes[1].is_animated = true;
    EXPECT_EQ(hw::pick(hw::build_pick_world(scene), {0, 0, 0}, kAhead)->object, 1u);
}

TEST(pick, agrees_with_asking_every_triangle)
{
    std::mt19937 random(3);
    std::normal_distribution<double> spread(0.0, 6.0);
    std::vector<glm::dmat4> places;
    for (int i = 0; i < 300; ++i)
        places.push_back(
            glm::rotate(at(spread(random), spread(random), spread(random)), spread(random), {0.3, 0.8, 0.5}));
    hw::Scene scene = sheets(places);
    const hw::PickWorld fast = hw::build_pick_world(scene);
    for (hw::Node& node : scene.nodes) node.is_animated = true;
    const hw::PickWorld slow = hw::build_pick_world(scene);
    int hits = 0;
    for (int ray = 0; ray < 2000; ++ray) {
        const glm::dvec3 direction = glm::normalize(glm::dvec3(spread(random), spread(random), spread(random)));
        const auto a = hw::pick(fast, {0, 0, 0}, direction), b = hw::pick(slow, {0, 0, 0}, direction);
        ASSERT_EQ(a.has_value(), b.has_value()) << ray;
        if (!a) continue;
        ++hits;
        ASSERT_EQ(a->object, b->object) << ray;
    }
    EXPECT_GT(hits, 500);
}
