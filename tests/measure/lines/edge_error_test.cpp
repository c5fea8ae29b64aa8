// Each figure of `measure edge-map` on a map that is broken on purpose, so that its value is known.
#include "measure/edges/edge_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "measure/edges/edge_cases.hpp"
#include "measure/edges/edge_drawing.hpp"

namespace hw::test {
namespace {

constexpr int kSide = 100;

Pixels filled(std::uint8_t value)
{
    return {kSide, kSide, 3, std::vector<std::uint8_t>(std::size_t{3} * kSide * kSide, value)};
}

/// An upright line at x = 40 through all of the picture.
std::vector<WantedEdge> upright(EdgeKind kind)
{
    std::vector<WantedEdge> edges;
    for (double y = 0.25; y < kSide; y += 0.5) edges.push_back({{40.0, y}, {1.0, 0.0}, 0.5, kind});
    return edges;
}

/// Marks columns of a channel from `x` on, in rows above `rows`.
Pixels marked(int x, int columns, int channel, int rows = kSide)
{
    Pixels map = filled(255);
    for (int y = 0; y < rows; ++y)
        for (int i = 0; i < columns; ++i) map.at(x + i, y)[channel] = 0;
    return map;
}

EdgeError judged(const Pixels& map, EdgeKind kind)
{
    return EdgeJudge(filled(255), upright(kind)).judge(map, 0.25);
}

}  // namespace

TEST(edge_error, of_a_right_map_is_none)
{
    const EdgeError error = judged(marked(40, 1, 1), EdgeKind::profile);
    EXPECT_NEAR(error.wanted_px[0], 100.0, 1e-9);
    EXPECT_EQ(error.recall(EdgeKind::profile), 1.0);
    EXPECT_EQ(error.profile_precision(), 1.0);
    EXPECT_NEAR(error.chamfer_px(), 0.5, 0.1) << "the middles of the pixels lie half a pixel beside the line";
    EXPECT_EQ(error.false_share(), 0.0);
}

TEST(edge_error, a_line_that_is_marked_for_a_quarter_is_missed_for_three)
{
    const EdgeError error = judged(marked(40, 1, 1, 25), EdgeKind::profile);
    EXPECT_NEAR(error.recall(EdgeKind::profile), 0.26, 0.011);
    EXPECT_EQ(error.profile_precision(), 1.0);
    EXPECT_GT(error.chamfer_px(), 4.0);
}

TEST(edge_error, marks_beside_the_line_are_wrong_and_false_from_two_pixels_on)
{
    const EdgeError error = judged(marked(40, 4, 1), EdgeKind::profile);
    EXPECT_NEAR(error.profile_precision(), 0.25, 1e-9);
    EXPECT_NEAR(error.false_share(), 0.02, 1e-9) << "of the columns the two that are 2.5 and 3.5 pixels away";
}

TEST(edge_error, a_profile_asks_for_a_mark_of_a_profile_and_a_crease_for_any)
{
    EXPECT_EQ(judged(marked(40, 1, 0), EdgeKind::profile).recall(EdgeKind::profile), 0.0);
    EXPECT_EQ(judged(marked(40, 1, 0), EdgeKind::inner).recall(EdgeKind::inner), 1.0);
    EXPECT_EQ(judged(marked(40, 1, 1), EdgeKind::inner).recall(EdgeKind::inner), 1.0);
    EXPECT_EQ(judged(marked(40, 1, 1), EdgeKind::inner).profile_precision(), 0.0) << "of no profile";
    EXPECT_EQ(judged(marked(40, 1, 0), EdgeKind::inner).inner_precision(), 1.0);
}

TEST(edge_error, what_is_marked_where_no_object_is_does_not_count)
{
    const EdgeError error = EdgeJudge(filled(0), upright(EdgeKind::profile)).judge(marked(40, 9, 1), 0.25);
    EXPECT_EQ(error.profiles, 0.0);
    EXPECT_EQ(error.recall(EdgeKind::profile), 0.0);
}

TEST(edge_error, nothing_wanted_and_nothing_marked_have_no_value)
{
    const EdgeError error = EdgeJudge(filled(255), {}).judge(filled(255), 0.25);
    EXPECT_TRUE(std::isnan(error.recall(EdgeKind::profile)));
    EXPECT_TRUE(std::isnan(error.profile_precision()));
    EXPECT_TRUE(std::isnan(error.chamfer_px()));
    EXPECT_EQ(error.false_share(), 0.0);
}

TEST(edge_error, widths_are_all_ink_across_a_line_that_stands_alone)
{
    const EdgeJudge judge(filled(255), upright(EdgeKind::profile));
    const std::vector<float> ratios = judge.width_ratios(marked(36, 4, 1), 4.0);
    ASSERT_GT(ratios.size(), 150u);
    for (const float ratio : ratios) EXPECT_NEAR(ratio, 1.0f, 0.1f);
    std::vector<WantedEdge> crowd = upright(EdgeKind::profile);
    for (WantedEdge edge : upright(EdgeKind::inner)) {
        edge.at_px.x += 5.0;
        crowd.push_back(edge);
    }
    EXPECT_TRUE(EdgeJudge(filled(255), crowd).width_ratios(marked(36, 4, 1), 4.0).empty());
}

TEST(edge_error, a_picture_turned_four_times_is_itself)
{
    Pixels picture = marked(30, 2, 0, 20);
    const Pixels once = turned(picture);
    EXPECT_EQ(once.at(0, kSide - 1 - 30)[0], 0)
        << "what was at the right of the top row is at the top of the left column";
    EXPECT_EQ(turned(turned(turned(once))).bytes, picture.bytes);
}

TEST(edge_cases, have_their_lines_in_the_picture)
{
    std::vector<std::string> names;
    for (const EdgeCase& blind : edge_cases()) {
        const std::vector<WantedEdge> wanted = blind.wanted({700, 450});
        EXPECT_EQ(wanted.empty(), blind.lines.empty()) << blind.name;
        names.push_back(blind.name);
    }
    EXPECT_EQ(names.size(), 5u);
}

}  // namespace hw::test
