#include "hatchway/maps/ink_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace hw;

namespace {

/// Courses of stone: level beds and upright joints, the beds first to stay.
std::vector<MapStroke> stone_courses()
{
    std::vector<MapStroke> strokes;
    for (int course = 0; course < 16; ++course) {
        const double y = (course + 0.5) / 16.0;
        strokes.push_back(
            {.points = {{0.0, y}, {1.0, y}}, .priority = static_cast<double>(course % 4 == 0 ? 0 : 10 + course)});
        for (int joint = 0; joint < 8; ++joint) {
            const double x = (joint + (course % 2 ? 0.5 : 0.0)) / 8.0;
            strokes.push_back({.points = {{x, y}, {x, y + 1.0 / 16.0}}, .priority = 100.0 + course + joint});
        }
    }
    return strokes;
}

double tone_of(const Pixels& level)
{
    return mean_ink(plane_of(level));
}

/// The mean width of level strokes: ink of a column, divided by the number of dark runs in it.
double mean_width_of_level_lines(const Pixels& level)
{
    const InkPlane plane = plane_of(level);
    double ink = 0.0;
    int runs = 0;
    for (int x = 0; x < plane.width; x += std::max(plane.width / 16, 1)) {
        for (int y = 0; y < plane.height; ++y) {
            const float above = plane.at(x, (y + plane.height - 1) % plane.height);
            ink += plane.at(x, y);
            runs += plane.at(x, y) > 0.05f && above <= 0.05f;
        }
    }
    return runs ? ink / runs : 0.0;
}

}  // namespace

TEST(ink_map, strokes_keep_their_width_at_every_level)
{
    std::vector<MapStroke> beds;
    for (int i = 0; i < 16; ++i)
        beds.push_back({.points = {{0.0, (i + 0.37) / 16}, {1.0, (i + 0.37) / 16}}, .priority = 1.0 * i});
    const InkMap ink = make_ink_map(beds, {.pen_texels = 1.6});
    for (std::size_t i = 0; i < ink.map.levels.size() && ink.stroke_counts[i] >= 1; ++i)
        EXPECT_NEAR(mean_width_of_level_lines(ink.map.levels[i]), 1.6, 0.25 * 1.6) << "level " << i;
}

TEST(ink_map, the_tone_holds_down_to_the_level_with_fewer_than_three_strokes)
{
    const InkMap ink = make_ink_map(stone_courses(), {});
    const double tone = tone_of(ink.map.levels[0]);
    EXPECT_GT(tone, 0.05);
    for (std::size_t i = 0; i < ink.map.levels.size(); ++i) {
        if (ink.stroke_counts[i] < 3) break;
        EXPECT_NEAR(tone_of(ink.map.levels[i]), tone, 0.05) << "level " << i;
    }
    EXPECT_GE(ink.stroke_counts[3], 3u);
}

TEST(ink_map, levels_without_strokes_keep_the_tone_as_gray)
{
    const InkMap ink = make_ink_map(stone_courses(), {});
    EXPECT_EQ(ink.stroke_counts.back(), 0u);
    EXPECT_NEAR(tone_of(ink.map.levels.back()), tone_of(ink.map.levels.front()), 1.0 / 255.0);
}

TEST(ink_map, coarser_levels_show_fewer_strokes_and_those_of_low_priority)
{
    const InkMap ink = make_ink_map(stone_courses(), {});
    for (std::size_t i = 1; i < ink.stroke_counts.size(); ++i)
        EXPECT_LE(ink.stroke_counts[i], ink.stroke_counts[i - 1]);
    EXPECT_LT(ink.stroke_counts[2], ink.stroke_counts[0]);
    // The beds of priority 0 lie at 0.5/16, 4.5/16, ...: level 3 has 64 rows.
    EXPECT_LT(*ink.map.levels[3].at(30, 2), 128);
}

TEST(ink_map, minimum_filtering_doubles_the_share_of_ink_and_mean_filtering_loses_contrast)
{
    const InkMap ink = make_ink_map(stone_courses(), {});
    const Pixels& finest = ink.map.levels[0];
    const MapLevels minimum = filtered_by_minimum(finest, 1.0);
    const MapLevels mean = filtered_by_mean(finest, 1.0);
    EXPECT_GT(tone_of(minimum.levels[3]), 3.0 * tone_of(finest));
    EXPECT_NEAR(tone_of(mean.levels[3]), tone_of(finest), 0.01);
    const auto darkest = [](const Pixels& level) { return *std::min_element(level.bytes.begin(), level.bytes.end()); };
    EXPECT_LE(darkest(ink.map.levels[3]), 51);  // a pen of 1.6 texels between two texels covers 0.8 of each
    EXPECT_GT(darkest(mean.levels[4]), 120);
}

TEST(ink_map, a_stroke_over_the_border_comes_in_on_the_other_side)
{
    InkPlane plane(32, 32);
    draw_stroke(plane, {.points = {{0.9, 0.5}, {1.1, 0.5}}}, 2.0);
    EXPECT_GT(plane.at(31, 15), 0.9f);
    EXPECT_GT(plane.at(1, 15), 0.9f);
    EXPECT_EQ(plane.at(16, 15), 0.0f);
}

TEST(ink_map, a_dot_and_a_stroke_without_length_are_drawn)
{
    InkPlane plane(16, 16);
    draw_stroke(plane, {.points = {{0.5, 0.5}}}, 2.0);
    draw_stroke(plane, {.points = {{0.25, 0.25}, {0.25, 0.25}}}, 2.0);
    EXPECT_GT(plane.at(8, 8), 0.5f);
    EXPECT_GT(plane.at(4, 4), 0.5f);
}

TEST(ink_map, even_ranks_put_a_far_stroke_before_a_near_one)
{
    std::vector<MapStroke> strokes{{.points = {{0.1, 0.5}, {0.3, 0.5}}},
                                   {.points = {{0.1, 0.51}, {0.3, 0.51}}},
                                   {.points = {{0.6, 0.5}, {0.8, 0.5}}}};
    rank_evenly(strokes);
    EXPECT_LT(strokes[2].priority, strokes[1].priority);
}
