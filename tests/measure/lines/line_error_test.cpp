// Each figure of `measure lines` on a drawing that is broken on purpose, so that its value is known.
#include "measure/lines/line_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace hw::test {
namespace {

constexpr int kWidth = 400;
constexpr int kHeight = 300;

/// A pen that draws as it should: coverage by the distance from the segment.
void draw(InkImage& image, glm::dvec2 a, glm::dvec2 b, double width)
{
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const glm::dvec2 p(x + 0.5, y + 0.5), along = b - a;
            const double t = std::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0, 1.0);
            const double coverage = std::clamp(0.5 * width + 0.5 - glm::distance(p, a + t * along), 0.0, 1.0);
            image.at(x, y) = std::max(image.at(x, y), static_cast<float>(coverage));
        }
}

InkImage paper()
{
    return {kWidth, kHeight, std::vector<float>(std::size_t{kWidth} * kHeight, 0.0f)};
}

InkImage drawing_of(const std::vector<WantedLine>& lines, double width_factor = 1.0, glm::dvec2 shift = {0, 0})
{
    InkImage image = paper();
    for (const WantedLine& line : lines)
        for (std::size_t i = 0; i + 1 < line.points_px.size(); ++i)
            draw(image, line.points_px[i] + shift, line.points_px[i + 1] + shift, width_factor * line.width_px);
    return image;
}

/// Four lines of 200 px: level, upright, steep and one of two legs.
std::vector<WantedLine> four_lines()
{
    const double leg = 100.0 / std::numbers::sqrt2;
    return {{{{30, 30.3}, {230, 30.3}}, 2.0},
            {{{350.6, 40}, {350.6, 240}}, 1.5},
            {{{40, 60}, {40 + 200 * std::cos(1.0), 60 + 200 * std::sin(1.0)}}, 2.0},
            {{{180, 100}, {180 + leg, 100 + leg}, {180 + 2 * leg, 100}}, 2.0}};
}

}  // namespace

TEST(line_error, of_a_right_drawing_is_none)
{
    const auto lines = four_lines();
    const LineError error = line_error(drawing_of(lines), lines);
    EXPECT_NEAR(error.wanted_px, 800.0, 0.1);
    EXPECT_EQ(error.missed_share(), 0.0);
    EXPECT_EQ(error.leaked_share(), 0.0);
    EXPECT_EQ(error.gaps, 0);
    EXPECT_NEAR(error.width_quantile(0.5), 1.0, 0.03);
    EXPECT_GT(error.width_quantile(0.05), 0.95);
    EXPECT_GT(error.width_ratios.size(), 1300u) << "these lines stand alone nearly everywhere";
}

TEST(line_error, a_removed_line_is_missed_and_no_gap)
{
    const auto lines = four_lines();
    const std::vector<WantedLine> drawn{lines[0], lines[1], lines[3]};
    const LineError error = line_error(drawing_of(drawn), lines);
    EXPECT_NEAR(error.missed_share(), 0.25, 0.002);
    EXPECT_EQ(error.leaked_share(), 0.0);
    EXPECT_EQ(error.gaps, 0);
    EXPECT_NEAR(error.width_quantile(0.05), 0.0, 1e-6) << "a quarter has no width";
}

TEST(line_error, a_line_too_many_leaks_its_share_of_the_ink)
{
    const auto lines = four_lines();
    auto drawn = lines;
    drawn.push_back({{{30, 280}, {230, 280}}, 2.0});
    const LineError right = line_error(drawing_of(lines), lines);
    const LineError error = line_error(drawing_of(drawn), lines);
    const double extra = 200.0 * 2.0 + std::numbers::pi;  // its round ends too
    EXPECT_NEAR(error.leaked_share(), extra / (right.ink_px + extra), 0.003);
    EXPECT_EQ(error.missed_share(), 0.0);
}

TEST(line_error, a_shifted_drawing_is_missed_and_leaked)
{
    const std::vector<WantedLine> lines{{{{30, 30.3}, {230, 30.3}}, 2.0}};
    const LineError far = line_error(drawing_of(lines, 1.0, {0, 6}), lines);
    EXPECT_EQ(far.missed_share(), 1.0);
    EXPECT_EQ(far.leaked_share(), 1.0);
    const LineError near = line_error(drawing_of(lines, 1.0, {0, 0.5}), lines);
    EXPECT_EQ(near.missed_share(), 0.0) << "half a pixel is no error";
    EXPECT_EQ(near.leaked_share(), 0.0);
}

TEST(line_error, three_holes_are_three_gaps)
{
    const auto lines = four_lines();
    auto drawn = lines;
    drawn[0] = {{{30, 30.3}, {70, 30.3}}, 2.0};
    drawn.push_back({{{80, 30.3}, {120, 30.3}}, 2.0});
    drawn.push_back({{{130, 30.3}, {180, 30.3}}, 2.0});
    drawn.push_back({{{190, 30.3}, {230, 30.3}}, 2.0});
    const LineError error = line_error(drawing_of(drawn), lines);
    EXPECT_EQ(error.gaps, 3);
    EXPECT_NEAR(error.gaps_per_1000_px(), 3.0 / 0.8, 0.01);
    // Of 10 px each, round ends and a reach of a pixel at both sides leave about 6.
    EXPECT_NEAR(error.missed_px, 18.0, 4.0);
}

TEST(line_error, a_doubled_width_and_a_halved_one_are_seen)
{
    const auto lines = four_lines();
    EXPECT_NEAR(line_error(drawing_of(lines, 2.0), lines).width_quantile(0.5), 2.0, 0.06);
    EXPECT_NEAR(line_error(drawing_of(lines, 0.5), lines).width_quantile(0.5), 0.5, 0.03);
    EXPECT_EQ(line_error(drawing_of(lines, 1.5), lines).leaked_share(), 0.0) << "too wide by half a pixel is no leak";
}

TEST(line_error, a_half_hidden_line_has_half_its_width)
{
    const std::vector<WantedLine> lines{{{{30, 30.0}, {230, 30.0}}, 2.0}};
    InkImage drawing = drawing_of(lines);
    for (int x = 0; x < 60; ++x)
        for (int y = 30; y < kHeight; ++y) drawing.at(x, y) = 0.0f;  // a face covers the lower side
    const LineError error = line_error(drawing, lines);
    EXPECT_NEAR(error.width_quantile(0.05), 0.5, 0.02);
    EXPECT_NEAR(error.width_quantile(0.5), 1.0, 0.02);
    EXPECT_EQ(error.missed_share(), 0.0);
}

TEST(line_error, adds_up_over_pictures)
{
    const auto lines = four_lines();
    LineError sum = line_error(drawing_of(lines), lines);
    sum.add(line_error(paper(), lines));
    EXPECT_NEAR(sum.missed_share(), 0.5, 1e-9);
    EXPECT_EQ(sum.leaked_share(), 0.0);
}

TEST(line_error, where_no_line_is_wanted_none_is_missed_and_none_is_right)
{
    const LineError error = line_error(paper(), {});
    for (const double figure :
         {error.missed_share(), error.leaked_share(), error.gaps_per_1000_px(), error.width_quantile(0.5)})
        EXPECT_TRUE(std::isnan(figure));
}

TEST(ink, is_counted_in_linear_light)
{
    Pixels picture{2, 1, 3, {255, 255, 255, 188, 188, 188}};
    EXPECT_NEAR(ink_share(ink_of(picture)), 0.25, 0.002) << "188 of sRGB is half the light";
}

}  // namespace hw::test
