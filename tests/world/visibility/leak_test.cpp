#include "hatchway/world/visibility/leak.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/world/scene_builder.hpp"

namespace hw {
namespace {

using test::SceneBuilder;

constexpr glm::dvec3 kInside(-2, 0, 0);

std::vector<Leak> leaks_of(SceneBuilder& builder, const glm::dvec3& from = kInside)
{
    const InsidePlace place{"start", from};
    return find_leaks(builder.scene(), {}, {&place, 1}).leaks;
}

/// A room of thick walls around x, y, z in [-4, 4]; its wall at x = 4 has square holes of the given widths at y = 0.
void add_room(SceneBuilder& builder, const std::vector<std::pair<double, double>>& holes_at_z)
{
    builder.box({-4.5, -4.5, -4.5}, {-4, 4.5, 4.5}, false);
    builder.box({-4, -4.5, -4.5}, {4, -4, 4.5}, false);
    builder.box({-4, 4, -4.5}, {4, 4.5, 4.5}, false);
    builder.box({-4, -4, -4.5}, {4, 4, -4}, false);
    builder.box({-4, -4, 4}, {4, 4, 4.5}, false);
    double from = -4.5;
    for (const auto& [z, width] : holes_at_z) {
        const double w = 0.5 * width;
        builder.box({4, -4.5, from}, {4.5, 4.5, z - w}, false);
        builder.box({4, -4.5, z - w}, {4.5, -w, z + w}, false);
        builder.box({4, w, z - w}, {4.5, 4.5, z + w}, false);
        from = z + w;
    }
    builder.box({4, -4.5, from}, {4.5, 4.5, 4.5}, false);
}

TEST(leak, a_closed_room_is_sealed)
{
    SceneBuilder thin;
    thin.box({-4, -4, -4}, {4, 4, 4}, true);
    EXPECT_TRUE(leaks_of(thin).empty()) << "also where walls are the faces of the scene's box";
    SceneBuilder thick;
    add_room(thick, {});
    EXPECT_TRUE(leaks_of(thick).empty());
}

TEST(leak, holes_down_to_a_millimetre_are_found_and_cracks_are_none)
{
    for (const double width : {1.0, 0.1, 0.01, 0.001}) {
        SceneBuilder builder;
        add_room(builder, {{1.0, width}});
        const std::vector<Leak> leaks = leaks_of(builder);
        ASSERT_EQ(leaks.size(), 1u) << width;
        EXPECT_NEAR(leaks[0].opening_m2, width * width, 0.03 * width * width) << "snapped to the grid";
        EXPECT_LT(glm::distance(leaks[0].opening_world, {4.25, 0, 1}), 0.3 + width);
    }
    SceneBuilder cracked;
    add_room(cracked, {{1.0, 3e-5}});
    EXPECT_TRUE(leaks_of(cracked).empty());
}

TEST(leak, the_line_leads_from_the_place_through_the_hole_to_the_outside)
{
    SceneBuilder builder;
    add_room(builder, {{1.0, 0.5}});
    builder.box({1, -4, -4}, {1.5, 4, 2}, false);  // to be gone around
    const std::vector<Leak> leaks = leaks_of(builder);
    ASSERT_EQ(leaks.size(), 1u);
    const std::vector<glm::dvec3>& points = leaks[0].points_world;
    EXPECT_EQ(points.front(), kInside);
    EXPECT_GT(points.back().x, 4.5);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        for (double t = 0.0; t <= 1.0; t += 0.01) {
            const glm::dvec3 p = points[i] + t * (points[i + 1] - points[i]);
            const bool is_in_screen = p.x > 1.001 && p.x < 1.499 && p.z < 1.999;
            const bool is_in_wall = p.x > 4.001 && p.x < 4.499 && (std::abs(p.y) > 0.251 || std::abs(p.z - 1) > 0.251);
            ASSERT_FALSE(is_in_screen || is_in_wall) << i << " " << t;
        }
    }
}

TEST(leak, every_hole_is_told_once_the_widest_first)
{
    SceneBuilder builder;
    add_room(builder, {{-2.5, 0.2}, {0.0, 0.8}, {2.5, 0.4}});
    const std::vector<Leak> leaks = leaks_of(builder);
    ASSERT_EQ(leaks.size(), 3u);
    EXPECT_NEAR(leaks[0].opening_world.z, 0.0, 0.5);
    EXPECT_NEAR(leaks[1].opening_world.z, 2.5, 0.5);
    EXPECT_NEAR(leaks[2].opening_world.z, -2.5, 0.5);
}

TEST(leak, walls_that_look_the_other_way_let_sight_out)
{
    SceneBuilder builder;
    builder.box({-4, -4, -4}, {4, 4, 4}, false);
    EXPECT_FALSE(leaks_of(builder).empty());
}

TEST(leak, glass_lets_sight_out)
{
    SceneBuilder builder;
    add_room(builder, {{0.0, 1.0}});
    builder.box({4.2, -0.5, -0.5}, {4.3, 0.5, 0.5}, false, SceneBuilder::kBlend);
    EXPECT_EQ(leaks_of(builder).size(), 1u);
}

TEST(leak, a_place_that_is_outside_is_told)
{
    SceneBuilder builder;
    add_room(builder, {});
    ASSERT_EQ(leaks_of(builder, {4.9, 0, 0}).size(), 1u);
    const std::vector<Leak> far = leaks_of(builder, {100, 0, 0});
    ASSERT_EQ(far.size(), 1u);
    EXPECT_EQ(far[0].points_world.size(), 1u);
}

TEST(leak, looks_from_the_start_or_else_from_the_cameras_or_paths)
{
    Level level;
    EXPECT_TRUE(inside_places(level).empty());
    level.paths = {{.name = "tour", .keys = {{0.0, {1, 2, 3}, {}}, {1.0, {4, 5, 6}, {}}}}};
    EXPECT_EQ(inside_places(level).size(), 2u);
    level.cameras = {{.name = "door", .eye_world = {7, 8, 9}}};
    ASSERT_EQ(inside_places(level).size(), 1u);
    EXPECT_EQ(inside_places(level)[0].name, "camera door");
    level.start = StartPlace{};
    EXPECT_EQ(inside_places(level)[0].name, "start");
}

}  // namespace
}  // namespace hw
