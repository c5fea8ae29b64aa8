#include "hatchway/drawing/line_strokes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace hw::test {
namespace {

StrokeSegment segment(glm::vec3 a, glm::vec3 b, LineClass line_class = LineClass::border)
{
    return {{a, b}, line_class};
}

}  // namespace

TEST(line_strokes, run_on_over_lines_that_turn_a_little_whichever_way_they_are_stated)
{
    const std::vector<StrokeSegment> segments{segment({0, 0, 0}, {1, 0, 0}), segment({2, 0.2f, 0}, {1, 0, 0}),
                                              segment({2, 0.2f, 0}, {3, 0.5f, 0})};
    const auto strokes = find_strokes(segments);
    const float second = std::sqrt(1.04f), third = std::sqrt(1.09f), whole = 1.0f + second + third;
    EXPECT_NEAR(strokes[0].from, 0.0f, 1e-6f);
    EXPECT_NEAR(strokes[0].to, 1.0f, 1e-6f);
    EXPECT_NEAR(strokes[1].to, 1.0f, 1e-6f) << "stated backwards";
    EXPECT_NEAR(strokes[1].from, 1.0f + second, 1e-5f);
    EXPECT_NEAR(strokes[2].to, whole, 1e-5f);
    for (const LineStroke& stroke : strokes) {
        EXPECT_NEAR(stroke.length, whole, 1e-5f);
        EXPECT_EQ(stroke.seed, strokes[0].seed);
    }
}

TEST(line_strokes, end_at_corners_at_junctions_and_at_another_class)
{
    const glm::vec3 middle(0.0f);
    const auto corner = find_strokes(std::vector{segment({-1, 0, 0}, middle), segment(middle, {0, 1, 0})});
    EXPECT_NEAR(corner[0].length, 1.0f, 1e-6f);
    EXPECT_NE(corner[0].seed, corner[1].seed) << "no two strokes are drawn alike";
    const auto junction =
        find_strokes(std::vector{segment({-1, 0, 0}, middle), segment(middle, {1, 0, 0}), segment(middle, {0, 1, 0})});
    for (const LineStroke& stroke : junction) EXPECT_NEAR(stroke.length, 1.0f, 1e-6f);
    const auto classes =
        find_strokes(std::vector{segment({-1, 0, 0}, middle), segment(middle, {1, 0, 0}, LineClass::ridge)});
    EXPECT_NEAR(classes[0].length, 1.0f, 1e-6f);
}

TEST(line_strokes, that_are_closed_have_no_ends)
{
    std::vector<StrokeSegment> ring;
    constexpr int kCount = 16;
    const auto at = [](int i) {
        const double angle = 2.0 * 3.14159265358979 * (i % kCount) / kCount;
        return glm::vec3(std::cos(angle), std::sin(angle), 0.0);
    };
    for (int i = 0; i < kCount; ++i) ring.push_back(segment(at(i), at(i + 1)));
    const double around = kCount * 2.0 * std::sin(3.14159265358979 / kCount);
    for (const LineStroke& stroke : find_strokes(ring)) EXPECT_NEAR(stroke.length, -around, 1e-4);
}

}  // namespace hw::test
