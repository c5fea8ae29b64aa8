#include "hatchway/world/visibility/visibility.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "hatchway/core/error.hpp"
#include "hatchway/world/visibility/rows/leaf_clusters.hpp"
#include "hatchway/world/visibility/rows/pvs.hpp"
#include "hatchway/world/visibility/tree/portal_polygon.hpp"
#include "hatchway/world/visibility/tree/portals.hpp"
#include "tests/world/scene_builder.hpp"

namespace hw {
namespace {

using test::compile;
using test::Compiled;
using test::SceneBuilder;

/// A wall of the given thickness at x = 0 within y, z in [-5, 5], with a square opening at y, z in [-w/2, w/2]; solid,
/// drawn from outside.
void add_wall_with_opening(SceneBuilder& builder, double thickness, double width, double depth = 5.0)
{
    const double x = 0.5 * thickness, w = 0.5 * width;
    builder.box({-x, -5, -depth}, {x, -w, depth}, false);
    builder.box({-x, w, -depth}, {x, 5, depth}, false);
    builder.box({-x, -w, -depth}, {x, w, -w}, false);
    builder.box({-x, -w, w}, {x, w, depth}, false);
}

/// Across the room from (-10, -5, -5) to (10, 5, 5); looks to -x.
const std::array<glm::dvec3, 4> kWall{{{0, -5, -5}, {0, -5, 5}, {0, 5, 5}, {0, 5, -5}}};

struct BothEnds {
    ObjectId left, right;
};

/// Something to see at each end of that room.
BothEnds add_box_at_each_end(SceneBuilder& builder)
{
    const ObjectId left = builder.box({-8, -1, -1}, {-7, 1, 1}, false);
    return {left, builder.box({7, -1, -1}, {8, 1, 1}, false)};
}

/// That room with six walls that leave narrow ways.
SceneBuilder six_walls()
{
    SceneBuilder builder;
    builder.box({-10, -5, -5}, {10, 5, 5}, true);
    for (int i = 0; i < 6; ++i) builder.box({-8.0 + 3 * i, -5, -5}, {-7.5 + 3 * i, 5, i % 2 ? 4.0 : 3.0}, false);
    return builder;
}

TEST(visibility, a_closed_wall_hides_what_is_behind_it)
{
    SceneBuilder builder;
    builder.box({-10, -5, -5}, {10, 5, 5}, true);
    builder.box({-0.5, -5, -5}, {0.5, 5, 5}, false);
    const auto [left, right] = add_box_at_each_end(builder);
    const Compiled compiled = compile(builder.scene());
    EXPECT_TRUE(compiled.sees({-3, 0, 0}, left));
    EXPECT_FALSE(compiled.sees({-3, 0, 0}, right));
    EXPECT_TRUE(compiled.sees({3, 0, 0}, right));
    EXPECT_FALSE(compiled.sees({3, 0, 0}, left));
}

TEST(visibility, slits_down_to_a_millimetre_are_never_lost)
{
    for (const double width : {1.0, 0.1, 0.05, 0.01, 0.001}) {
        SceneBuilder builder;
        builder.box({-10, -5, -5}, {10, 5, 5}, true);
        add_wall_with_opening(builder, 0.3, width);
        const ObjectId target = builder.box({7, -1, -1}, {8, 1, 1}, false);
        for (const PvsEffort effort : {PvsEffort::fast, PvsEffort::full, PvsEffort::exact}) {
            VisibilityOptions options;
            options.effort = effort;
            EXPECT_TRUE(compile(builder.scene(), options).sees({-3, 0, 0}, target)) << width;
        }
    }
}

TEST(visibility, slits_in_two_walls_in_a_row_are_never_lost)
{
    for (const double width : {0.1, 0.01, 0.001}) {
        SceneBuilder builder;
        builder.box({-10, -5, -5}, {10, 5, 5}, true);
        for (const double x : {-2.0, 2.0}) {
            const double w = 0.5 * width;
            builder.box({x - 0.1, -5, -5}, {x + 0.1, 5, -w}, false);
            builder.box({x - 0.1, -5, w}, {x + 0.1, 5, 5}, false);
        }
        const ObjectId target = builder.box({7, -1, -1}, {8, 1, 1}, false);
        EXPECT_TRUE(compile(builder.scene()).sees({-5, 0, 0}, target)) << width;
    }
}

TEST(visibility, openings_that_no_line_passes_together_hide)
{
    SceneBuilder builder;
    builder.box({-10, -5, -5}, {10, 5, 5}, true);
    for (int i = -1; i <= 1; ++i) {
        const double x = 4.0 * i, from = i == 0 ? 3.0 : -4.0;
        builder.box({x - 0.2, -5, -5}, {x + 0.2, 5, from}, false);
        builder.box({x - 0.2, -5, from + 1.0}, {x + 0.2, 5, 5}, false);
    }
    const ObjectId first = builder.box({-1, -1, -1}, {-0.8, 1, 1}, false);
    const ObjectId last = builder.box({7, -1, -1}, {8, 1, 1}, false);
    const Compiled compiled = compile(builder.scene());
    EXPECT_TRUE(compiled.sees({-5, 0, -4}, first));
    EXPECT_FALSE(compiled.sees({-8, 0, 0}, last));
}

TEST(visibility, a_leaf_a_hundredth_thick_passes_sight)
{
    SceneBuilder builder;
    builder.box({-10, -5, -5}, {10, 5, 5}, true);
    add_wall_with_opening(builder, 0.01, 2.0);
    const ObjectId target = builder.box({7, -1, -1}, {8, 1, 1}, false);
    EXPECT_TRUE(compile(builder.scene()).sees({-3, 0, 0}, target));
}

TEST(visibility, a_single_sided_wall_blocks_from_its_front_and_not_from_behind)
{
    SceneBuilder builder;
    builder.box({-10, -5, -5}, {10, 5, 5}, true);
    builder.quad(kWall);
    const auto [left, right] = add_box_at_each_end(builder);
    const Compiled compiled = compile(builder.scene());
    EXPECT_FALSE(compiled.sees({-3, 0, 0}, right)) << "its front hides what is behind it";
    EXPECT_TRUE(compiled.sees({3, 0, 0}, left)) << "from behind it is not drawn";
}

TEST(visibility, a_mirrored_node_turns_the_drawn_side_round)
{
    SceneBuilder builder;
    builder.box({-10, -5, -5}, {10, 5, 5}, true);
    const ObjectId wall = builder.quad(kWall);
    builder.scene().nodes[wall].world_from_node[0][0] = -1.0;  // now it looks to +x
    const auto [left, right] = add_box_at_each_end(builder);
    const Compiled compiled = compile(builder.scene());
    EXPECT_TRUE(compiled.sees({-3, 0, 0}, right));
    EXPECT_FALSE(compiled.sees({3, 0, 0}, left));
}

TEST(visibility, a_double_sided_wall_blocks_both_ways)
{
    SceneBuilder builder;
    builder.box({-10, -5, -5}, {10, 5, 5}, true);
    builder.quad(kWall, SceneBuilder::kDouble);
    const auto [left, right] = add_box_at_each_end(builder);
    const Compiled compiled = compile(builder.scene());
    EXPECT_FALSE(compiled.sees({-3, 0, 0}, right));
    EXPECT_FALSE(compiled.sees({3, 0, 0}, left));
}

TEST(visibility, glass_foliage_and_moving_doors_hide_nothing)
{
    for (const int material : {SceneBuilder::kBlend, SceneBuilder::kMask, SceneBuilder::kSingle}) {
        SceneBuilder builder;
        builder.box({-10, -5, -5}, {10, 5, 5}, true);
        const ObjectId wall = builder.box({-0.5, -5, -5}, {0.5, 5, 5}, false, material);
        builder.scene().nodes[wall].is_animated = material == SceneBuilder::kSingle;
        const ObjectId right = builder.box({7, -1, -1}, {8, 1, 1}, false);
        EXPECT_TRUE(compile(builder.scene()).sees({-3, 0, 0}, right));
    }
}

TEST(visibility, a_portal_of_over_24_corners)
{
    constexpr int kCorners = 100;
    SceneBuilder builder;
    builder.box({-10, -5, -5}, {10, 5, 5}, true);
    for (int i = 0; i < kCorners; ++i) {  // a wall with a round window
        const auto at = [](int k, double radius) {
            const double angle = 2.0 * 3.14159265358979 * k / kCorners;
            const double reach = std::min(std::abs(1.0 / std::cos(angle)), std::abs(1.0 / std::sin(angle)));
            const double r = radius > 2.0 ? 5.0 * reach : radius;
            return glm::dvec3(0.0, r * std::cos(angle), r * std::sin(angle));
        };
        builder.quad({{at(i, 1.0), at(i, 5.0), at(i + 1, 5.0), at(i + 1, 1.0)}}, SceneBuilder::kDouble);
    }
    const ObjectId ahead = builder.box({7, -1, -1}, {8, 1, 1}, false);
    VisibilityOptions options;
    options.least_area_share = 0.0;
    const Compiled compiled = compile(builder.scene(), options);
    EXPECT_TRUE(compiled.sees({-3, 0, 0}, ahead));
}

TEST(visibility, an_open_level_shows_everything_from_outside)
{
    SceneBuilder builder;
    builder.box({-10, -5, -5}, {10, 5, 5}, false);
    const ObjectId inside = builder.box({-1, -1, -1}, {1, 1, 1}, false);
    const Compiled compiled = compile(builder.scene());
    EXPECT_TRUE(compiled.sees({0, 50, 0}, inside)) << "outside of the compiled box";
    EXPECT_TRUE(compiled.sees({0, 3, 0}, inside)) << "inside of the wall";
}

TEST(visibility, scenes_without_a_volume_are_compiled_too)
{
    SceneBuilder empty;
    EXPECT_EQ(compile(empty.scene()).visibility.slots.size(), 0u);
    for (const glm::dvec3& size : {glm::dvec3(4, 3, 0), glm::dvec3(0, 3, 0.001), glm::dvec3(5, 0, 0), glm::dvec3(0)}) {
        SceneBuilder flat;
        const ObjectId sheet =
            flat.quad({{{0, 0, 0}, {size.x, 0, 0}, size, {0, size.y, size.z}}}, SceneBuilder::kDouble);
        EXPECT_TRUE(compile(flat.scene()).sees({0.1, 0.1, 1}, sheet));
    }
}

TEST(visibility, the_near_plane_may_poke_through_a_wall)
{
    SceneBuilder builder;
    builder.box({-10, -5, -5}, {10, 5, 5}, true);
    builder.quad(kWall, SceneBuilder::kDouble);
    const ObjectId right = builder.box({7, -1, -1}, {8, 1, 1}, false);
    const Compiled compiled = compile(builder.scene());
    std::vector<std::uint8_t> visible;
    visible_chunks(compiled.visibility, {-0.05, 0, 0}, 0.1, visible);
    EXPECT_TRUE(visible[compiled.visibility.first_slot_of_object[right]]);
    visible_chunks(compiled.visibility, {-0.5, 0, 0}, 0.1, visible);
    EXPECT_FALSE(visible[compiled.visibility.first_slot_of_object[right]]);
}

TEST(visibility, what_is_low_behind_a_half_high_wall_is_hidden_from_below_only)
{
    SceneBuilder builder;
    builder.box({-10, 0, -5}, {10, 8, 5}, true);
    builder.box({-6, 0, -5}, {6, 4, 5}, false);
    const ObjectId behind = builder.box({7, 0.01, -1}, {8, 0.5, 1}, false);
    const Compiled compiled = compile(builder.scene());
    EXPECT_FALSE(compiled.sees({-8, 0.5, 0}, behind));
    EXPECT_FALSE(compiled.sees({0, 7, 0}, behind)) << "the edge of the block is in the way";
    EXPECT_TRUE(compiled.sees({5.5, 7.5, 0}, behind));
}

TEST(visibility, is_the_same_for_any_number_of_threads)
{
    SceneBuilder builder = six_walls();
    VisibilityOptions one, four;
    one.threads = 1;
    four.threads = 4;
    const Compiled a = compile(builder.scene(), one);
    const Compiled b = compile(builder.scene(), four);
    ASSERT_EQ(a.visibility.tree.cluster_count, b.visibility.tree.cluster_count);
    for (int i = 0; i < a.visibility.tree.cluster_count; ++i) {
        for (int j = 0; j < a.visibility.tree.cluster_count; ++j) {
            ASSERT_EQ(a.visibility.rows.sees(i, j), b.visibility.rows.sees(i, j));
        }
    }
}

TEST(visibility, a_tight_budget_shows_more_and_never_less)
{
    SceneBuilder builder = six_walls();
    VisibilityOptions rich, poor;
    rich.flow_seconds = 0.0;
    poor.flow_seconds = 1e-9;
    const Compiled a = compile(builder.scene(), rich);
    const Compiled b = compile(builder.scene(), poor);
    ASSERT_EQ(a.visibility.tree.cluster_count, b.visibility.tree.cluster_count);
    for (int i = 0; i < a.visibility.tree.cluster_count; ++i) {
        for (int j = 0; j < a.visibility.tree.cluster_count; ++j) {
            if (a.visibility.rows.sees(i, j)) {
                ASSERT_TRUE(b.visibility.rows.sees(i, j));
            }
        }
    }
}

/// Eight rooms in a row that see each other through doorways.
Scene& rooms_in_a_row(SceneBuilder& builder)
{
    builder.box({0, 0, -4}, {80, 4, 4}, true);
    for (int wall = 1; wall < 8; ++wall) {
        const double x = 10.0 * wall;
        builder.box({x - 0.2, 0, -4}, {x + 0.2, 4, wall % 2 ? -1.0 : 0.0}, false);
        builder.box({x - 0.2, 0, wall % 2 ? 0.0 : 1.0}, {x + 0.2, 4, 4}, false);
    }
    return builder.scene();
}

TEST(visibility, a_level_that_is_too_fine_for_a_budget_is_told_with_counts_and_place)
{
    SceneBuilder builder;
    Scene& scene = rooms_in_a_row(builder);
    EXPECT_TRUE(compile(scene).visibility.stats.shortfalls.empty());
    VisibilityOptions few;
    few.max_clusters = 3;
    const Compiled merged = compile(scene, few);
    ASSERT_EQ(merged.visibility.stats.shortfalls.size(), 1u);
    const Shortfall& shortfall = merged.visibility.stats.shortfalls.front();
    EXPECT_NE(shortfall.what.find("the budget is 3"), std::string::npos) << shortfall.what;
    EXPECT_LE(shortfall.where_world.max.x - shortfall.where_world.min.x, 10.1) << "an eighth of the length";
    VisibilityOptions plain;
    plain.max_structure_polygons = 4;
    const Compiled demoted = compile(scene, plain);
    ASSERT_FALSE(demoted.visibility.stats.shortfalls.empty());
    EXPECT_NE(demoted.visibility.stats.shortfalls.front().what.find("the budget is 4"), std::string::npos);
}

TEST(visibility, where_very_many_clusters_have_nothing_in_common_the_smallest_are_merged_all_the_same)
{
    SceneBuilder builder;
    for (int i = 0; i < 9; ++i) builder.box({10.0 * i, 0, 0}, {10.0 * i + 1 + i, 4, 4}, true);  // no way leads out
    VisibilityStats stats;
    double area_m2 = 0.0;
    BspBuild build = build_sight_tree(builder.scene(), Level{}, {}, stats, area_m2);
    const std::vector<LeafContact> contacts = leaf_contacts(build);
    const int most = 4, of_solid = 1;
    EXPECT_FALSE(merge_clusters(build.tree, contacts, {.most_at_all = most}).empty());
    EXPECT_EQ(build.tree.cluster_count, most + of_solid);
    const auto cluster_at = [&](double x) {
        return build.tree.cluster_of_leaf[static_cast<std::size_t>(leaf_at(build.tree, {x, 2, 2}))];
    };
    EXPECT_EQ(cluster_at(0.5), cluster_at(20.5));
    EXPECT_NE(cluster_at(70.5), cluster_at(80.5)) << "the largest stay";
}

TEST(visibility, places_are_told_where_most_of_them_are)
{
    const Box bounds{{0, 0, 0}, {8, 8, 8}};
    const std::vector<glm::dvec3> places{{0.5, 0.5, 0.5}, {6.2, 3.1, 7.7}, {6.9, 3.8, 7.1}, {100, 0, 0}};
    const Box part = densest_part(places, bounds);
    EXPECT_EQ(part.min, glm::dvec3(6, 3, 7));
    EXPECT_EQ(part.max, glm::dvec3(7, 4, 8));
    EXPECT_EQ(densest_part({}, bounds).max, bounds.max);
}

}  // namespace
TEST(pvs, a_polygon_whose_sides_a_plane_cuts_many_times_stays_within_its_corners)
{
    Winding saw;
    saw.count = 60;
    for (int i = 0; i < saw.count; ++i)
        saw.points[static_cast<std::size_t>(i)] = {0.01 * i, i % 2 == 0 ? 1e-3 : -1e-3, 0.0};
    const Winding before = saw;
    EXPECT_TRUE(clip(saw, {{0, 1, 0}, 0.0}, {}));
    ASSERT_EQ(saw.count, before.count) << "kept whole";
    for (int i = 0; i < saw.count; ++i) EXPECT_EQ(saw[i], before[i]);
}

TEST(pvs, a_way_of_a_thousand_openings_is_followed_to_its_end)
{
    constexpr int kRooms = 1200;  // sights for sure are looked for through 400
    PortalGraph graph{.leaf_count = kRooms};
    for (int room = 0; room + 1 < kRooms; ++room) {
        const double x = 0.01 * room;
        const std::vector<glm::dvec3> opening{{x, 0, 0}, {x, 1, 0}, {x, 1, 1}, {x, 0, 1}};
        graph.portals.push_back({room, room + 1, {1, 0, 0}, -x, opening});
        graph.portals.push_back({room + 1, room, {-1, 0, 0}, x, opening});
    }
    const PvsResult result = build_pvs(graph, {.effort = PvsEffort::exact});
    EXPECT_TRUE(result.coarse_portals.empty());
    EXPECT_TRUE(result.rows.sees(0, kRooms - 1));
    EXPECT_TRUE(result.rows.sees(kRooms - 1, 0));
}

}  // namespace hw
