#include "hatchway/world/visibility/rows/sight_slices.hpp"

#include <gtest/gtest.h>

#include "hatchway/world/visibility/rows/leaf_clusters.hpp"
#include "hatchway/world/visibility/tree/structure.hpp"
#include "tests/world/scene_builder.hpp"

namespace hw {
namespace {

using test::compile;
using test::SceneBuilder;

/// The slices of a scene; boxes are asked for in world space.
struct Sliced {
    glm::dvec3 origin{0.0};
    SightSlices slices;

    bool hides(const Box& eyes, const Box& target) const
    {
        int last = -1;
        return slices.hides({eyes.min - origin, eyes.max - origin}, {target.min - origin, target.max - origin}, last);
    }
};

Sliced sliced(const Scene& scene)
{
    StructureOptions options;
    options.least_area_share = 0.0;
    Structure s = choose_structure(scene, Level{}, options);
    BspBuild build = build_bsp(s.grid, s.planes, s.polygons, s.box_min, s.box_max);
    const std::vector<LeafContact> contacts = leaf_contacts(build);
    return {s.grid.origin_world, SightSlices(build, contacts, leaf_boxes(build.tree, contacts), {})};
}

const Box kLeft{{-8, -3, -3}, {-4, 3, 3}};
const Box kRight{{4, -3, -3}, {8, 3, 3}};

/// A thin two-sided wall at x = 0 of two panels with `gap` between them at z = 0.
Scene panels(double gap)
{
    SceneBuilder builder;
    builder.box({-10, -5, -5}, {10, 5, 5}, true);
    builder.quad({{{0, -5, -5}, {0, -5, -0.5 * gap}, {0, 5, -0.5 * gap}, {0, 5, -5}}}, SceneBuilder::kDouble);
    builder.quad({{{0, -5, 0.5 * gap}, {0, -5, 5}, {0, 5, 5}, {0, 5, 0.5 * gap}}}, SceneBuilder::kDouble);
    return builder.scene();
}

TEST(sight_slices, panels_that_meet_hide_together_what_neither_hides_alone)
{
    EXPECT_TRUE(sliced(panels(0.0)).hides(kLeft, kRight));
    EXPECT_TRUE(sliced(panels(0.0)).hides(kRight, kLeft));
}

TEST(sight_slices, a_slit_of_a_millimetre_hides_nothing_behind_it)
{
    for (const double gap : {1.0, 0.1, 0.05, 0.001}) EXPECT_FALSE(sliced(panels(gap)).hides(kLeft, kRight)) << gap;
}

TEST(sight_slices, what_the_slit_cannot_show_is_hidden)
{
    const Box aside{{-1.0, -1, 3}, {-0.5, 1, 4}};
    EXPECT_TRUE(sliced(panels(0.001)).hides(aside, {{0.5, -1, 3}, {1.0, 1, 4}}));
}

TEST(sight_slices, a_single_sided_wall_hides_from_its_front_alone)
{
    SceneBuilder builder;
    builder.box({-11, -6, -6}, {11, 6, 6}, false);  // so that the room's own faces count: its right half is no inside
    builder.box({-10, -5, -5}, {10, 5, 5}, true);
    builder.quad({{{0, -5, -5}, {0, -5, 5}, {0, 5, 5}, {0, 5, -5}}});  // looks to -x
    const Sliced result = sliced(builder.scene());
    EXPECT_TRUE(result.hides(kLeft, kRight));
    EXPECT_FALSE(result.hides(kRight, kLeft));
}

TEST(sight_slices, bricks_of_different_depth_hide_by_the_inside_that_they_share)
{
    SceneBuilder builder;
    builder.box({-10, -5, -5}, {10, 5, 5}, true);
    for (int i = 0; i < 10; ++i) {
        const double out = 0.3 + 0.01 * i, z = -5.0 + i;
        builder.box({-out, -5, z}, {out, 5, z + 1}, false);
    }
    EXPECT_TRUE(sliced(builder.scene()).hides(kLeft, kRight));
}

TEST(sight_slices, what_lies_in_the_plane_of_the_wall_is_not_behind_it)
{
    const Box on_wall{{0, -1, -4}, {0, 1, -3}};
    EXPECT_FALSE(sliced(panels(0.0)).hides(kLeft, on_wall));
}

TEST(view_cells, rows_are_the_same_for_any_number_of_threads)
{
    SceneBuilder builder;
    builder.box({-10, -5, -5}, {10, 5, 5}, true);
    for (int i = 0; i < 6; ++i) builder.box({-8.0 + 3 * i, -5, -5}, {-7.5 + 3 * i, 5, i % 2 ? 4.0 : 3.0}, false);
    VisibilityOptions one, two;
    one.threads = 1;
    two.threads = 2;
    const test::Compiled a = compile(builder.scene(), one);
    const test::Compiled b = compile(builder.scene(), two);
    ASSERT_EQ(a.visibility.tree.cluster_of_leaf, b.visibility.tree.cluster_of_leaf);
    for (int cell = 0; cell < a.visibility.tree.cluster_count; ++cell) {
        const auto row_a = a.visibility.slot_rows.row(cell), row_b = b.visibility.slot_rows.row(cell);
        ASSERT_TRUE(std::equal(row_a.begin(), row_a.end(), row_b.begin()));
    }
}

TEST(view_cells, an_eye_sees_less_than_the_room_that_it_stands_in)
{
    SceneBuilder builder;  // two arms of one open space around a block
    builder.box({-10, -5, -10}, {10, 5, 10}, true);
    builder.box({-10, -5, -10}, {4, 5, 4}, false);
    const ObjectId far = builder.box({8, -1, -9}, {9, 1, -8}, false);
    const test::Compiled compiled = compile(builder.scene());
    EXPECT_FALSE(compiled.sees({-9, 0, 5}, far)) << "round the corner";
    EXPECT_TRUE(compiled.sees({9, 0, 5}, far));
}

}  // namespace
}  // namespace hw
