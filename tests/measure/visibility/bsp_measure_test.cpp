// The measure of the tree on input that is broken on purpose, with wrong values that are known.
#include "measure/visibility/bsp_measure.hpp"
#include "hatchway/world/visibility/tree/structure.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/world/scene_builder.hpp"

namespace hw {
namespace {

using test::SceneBuilder;

constexpr std::uint64_t kPoints = 20'000;

struct Built {
    Structure structure;
    BspBuild build;
};

/// Four equal squares in the plane x = 0, two and two apart from each other, within a box that they part in the middle.
Built four_squares_in_one_plane()
{
    SceneBuilder builder;
    for (const double y : {-4.0, 2.0}) {
        for (const double z : {-4.0, 2.0}) builder.quad({{{0, y, z}, {0, y + 2, z}, {0, y + 2, z + 2}, {0, y, z + 2}}});
    }
    builder.box({-5, -5, -5}, {5, 5, 5}, true);
    StructureOptions options;
    options.least_area_share = 0.0;
    Built result;
    result.structure = choose_structure(builder.scene(), Level{}, options);
    const Structure& s = result.structure;
    result.build = build_bsp(s.grid, s.planes, s.polygons, s.box_min, s.box_max);
    return result;
}

TEST(bsp_measure, a_whole_tree_has_no_wrong_point_and_no_area_error)
{
    const Built built = four_squares_in_one_plane();
    ASSERT_EQ(built.build.tree.nodes.size(), 1u);
    EXPECT_EQ(measure::misclassified(built.build.tree, kPoints), 0u);
    EXPECT_LT(measure::relative_area_error(built.structure.area_m2, built.build), 1e-12);
}

TEST(bsp_measure, of_no_area_there_is_no_error)
{
    EXPECT_TRUE(std::isnan(measure::relative_area_error(0.0, four_squares_in_one_plane().build)));
}

std::uint64_t wrong_where_the_plane_looks_the_other_way()
{
    Built built = four_squares_in_one_plane();
    ExactPlane& plane = built.build.tree.nodes[0].plane;
    plane.unit_normal = -plane.unit_normal;
    plane.unit_offset = -plane.unit_offset;
    return measure::misclassified(built.build.tree, kPoints);
}

TEST(bsp_measure, a_plane_whose_rounded_copy_looks_the_other_way_puts_every_point_wrong_that_it_is_believed_for)
{
    // All of the uniform half; of the half that is aimed at the plane those that are not left to exact arithmetic.
    const std::uint64_t wrong = wrong_where_the_plane_looks_the_other_way();
    EXPECT_GT(wrong, kPoints / 2 + kPoints / 4);
    EXPECT_LT(wrong, kPoints);
}

TEST(bsp_measure, a_plane_moved_by_a_quarter_of_the_box_puts_a_quarter_of_the_points_wrong)
{
    Built built = four_squares_in_one_plane();
    BspTree& tree = built.build.tree;
    tree.nodes[0].plane.unit_offset += 2.5 / tree.grid.step_m;
    // Of the uniform half those between the planes; of the half that is aimed at the moved plane those on its one side,
    // where the rounded copy is believed: as often as above.
    const double believed = 2.0 * static_cast<double>(wrong_where_the_plane_looks_the_other_way()) / kPoints - 1.0;
    const double wrong = static_cast<double>(measure::misclassified(tree, kPoints)) / kPoints;
    EXPECT_NEAR(wrong, 0.5 * 0.25 + 0.5 * 0.5 * believed, 0.02);
}

TEST(bsp_measure, a_lost_piece_of_four_and_a_doubled_one_are_a_quarter_of_the_area)
{
    Built lost = four_squares_in_one_plane();
    ASSERT_EQ(lost.build.polygons_of_node[0].size(), 4u);
    lost.build.polygons_of_node[0].pop_back();
    EXPECT_NEAR(measure::relative_area_error(lost.structure.area_m2, lost.build), 0.25, 1e-9);
    Built doubled = four_squares_in_one_plane();
    doubled.build.polygons_of_node[0].push_back(doubled.build.polygons_of_node[0].front());
    EXPECT_NEAR(measure::relative_area_error(doubled.structure.area_m2, doubled.build), 0.25, 1e-9);
}

}  // namespace
}  // namespace hw
