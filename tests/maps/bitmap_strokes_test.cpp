#include "hatchway/maps/bitmap_strokes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "hatchway/maps/ink_map.hpp"
#include "hatchway/maps/thinning.hpp"

using namespace hw;

namespace {

Pixels drawn(const std::vector<MapStroke>& strokes, int size, double pen)
{
    InkPlane plane(size, size);
    for (const MapStroke& stroke : strokes) draw_stroke(plane, stroke, pen);
    return level_of(plane);
}

double length_of(const MapStroke& stroke)
{
    double length = 0.0;
    for (std::size_t i = 1; i < stroke.points.size(); ++i)
        length += glm::distance(stroke.points[i - 1], stroke.points[i]);
    return length;
}

MapStroke circle(const glm::dvec2& middle, double radius)
{
    MapStroke stroke;
    for (int i = 0; i <= 64; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 64.0;
        stroke.points.push_back(middle + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return stroke;
}

}  // namespace

TEST(bitmap_strokes, two_lines_that_cross_are_two_strokes)
{
    const std::vector<MapStroke> lines{{.points = {{0.1, 0.2}, {0.9, 0.8}}}, {.points = {{0.2, 0.9}, {0.7, 0.1}}}};
    for (const double pen : {1.5, 4.0, 7.0}) {
        const std::vector<MapStroke> found = strokes_of_bitmap(drawn(lines, 256, pen));
        ASSERT_EQ(found.size(), 2u) << "pen " << pen;
        for (const MapStroke& stroke : found) EXPECT_GT(length_of(stroke), 0.85) << "pen " << pen;
    }
}

TEST(bitmap_strokes, a_stroke_lies_on_the_line_that_was_drawn)
{
    const MapStroke line{.points = {{0.1, 0.3}, {0.8, 0.5}}};
    const std::vector<MapStroke> found = strokes_of_bitmap(drawn({line}, 256, 3.0));
    ASSERT_EQ(found.size(), 1u);
    const glm::dvec2 along = glm::normalize(line.points[1] - line.points[0]);
    for (const glm::dvec2& p : found[0].points) {
        const glm::dvec2 d = p - line.points[0];
        EXPECT_LT(std::abs(d.x * along.y - d.y * along.x) * 256.0, 0.8);
    }
}

TEST(bitmap_strokes, a_wide_line_among_narrow_ones_keeps_its_relative_width)
{
    std::vector<MapStroke> lines;
    for (int i = 1; i < 8; ++i)
        lines.push_back({.points = {{0.1, i / 9.0}, {0.9, i / 9.0}}, .width = i == 4 ? 3.0 : 1.0});
    std::vector<MapStroke> found = strokes_of_bitmap(drawn(lines, 256, 3.0));
    ASSERT_EQ(found.size(), 7u);
    std::ranges::sort(found, {}, &MapStroke::width);
    EXPECT_NEAR(found[3].width, 1.0, 0.05);
    EXPECT_NEAR(found[6].width, 3.0, 0.5);
    EXPECT_LT(found[5].width, 1.3);
}

TEST(bitmap_strokes, a_line_that_leaves_the_drawing_goes_on_at_the_other_side)
{
    const std::vector<MapStroke> found = strokes_of_bitmap(drawn({{.points = {{0.6, 0.3}, {1.4, 0.5}}}}, 128, 2.0));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(length_of(found[0]), 0.82, 0.05);
}

TEST(bitmap_strokes, a_circle_is_one_closed_stroke_and_a_spot_a_dot)
{
    const std::vector<MapStroke> ring = strokes_of_bitmap(drawn({circle({0.5, 0.5}, 0.3)}, 256, 2.0));
    ASSERT_EQ(ring.size(), 1u);
    EXPECT_NEAR(length_of(ring[0]), 2.0 * std::numbers::pi * 0.3, 0.06);
    const std::vector<MapStroke> spot = strokes_of_bitmap(drawn({{.points = {{0.5, 0.5}}}}, 64, 2.0));
    ASSERT_EQ(spot.size(), 1u);
    EXPECT_LT(glm::distance(spot[0].points[0], glm::dvec2(0.5)), 0.03);
}

TEST(bitmap_strokes, paper_gives_no_strokes_and_solid_ink_ends)
{
    EXPECT_TRUE(strokes_of_bitmap(drawn({}, 64, 2.0)).empty());
    const Pixels black{.width = 64, .height = 64, .channels = 1, .bytes = std::vector<std::uint8_t>(64 * 64, 0)};
    EXPECT_LE(strokes_of_bitmap(black).size(), 64u * 64u);
}

TEST(bitmap_strokes, drawn_again_the_strokes_of_a_wall_give_the_wall)
{
    std::vector<MapStroke> courses;
    for (int course = 0; course < 8; ++course) {
        const double y = (course + 0.4) / 8.0;
        courses.push_back({.points = {{0.0, y}, {1.0, y}}});
        for (int joint = 0; joint < 4; ++joint) {
            const double x = (joint + (course % 2 ? 0.6 : 0.1)) / 4.0;
            courses.push_back({.points = {{x, y}, {x, y + 1.0 / 8.0}}});
        }
    }
    const Pixels wall = drawn(courses, 256, 2.0);
    std::vector<MapStroke> found = strokes_of_bitmap(wall);
    EXPECT_GE(found.size(), 32u);
    EXPECT_LE(found.size(), 48u);
    const Pixels again = drawn(found, 256, 2.0);
    double difference = 0.0;
    for (std::size_t i = 0; i < wall.bytes.size(); ++i) difference += std::abs(wall.bytes[i] - again.bytes[i]) / 255.0;
    EXPECT_LT(difference / static_cast<double>(wall.bytes.size()), 0.03);
    rank_evenly(found);
    const InkMap ink = make_ink_map(found, {.width_texels = 256, .height_texels = 256});
    EXPECT_GE(ink.stroke_counts[2], 3u);
    EXPECT_LT(ink.stroke_counts[2], found.size());
}

TEST(thinning, a_wide_bar_becomes_a_line_one_pixel_wide)
{
    InkMask bar{.width = 40, .height = 20, .ink = std::vector<std::uint8_t>(800, 0)};
    for (int y = 6; y < 13; ++y)
        for (int x = 5; x < 35; ++x) bar.ink[bar.place(x, y)] = 1;
    const InkMask line = thinned(bar);
    for (int x = 10; x < 30; ++x) {
        int count = 0;
        for (int y = 0; y < 20; ++y) count += line.at(x, y) ? 1 : 0;
        EXPECT_EQ(count, 1) << "column " << x;
    }
    EXPECT_NEAR(distance_to_paper(bar)[bar.place(20, 9)], 4.0f, 0.01f);
}
