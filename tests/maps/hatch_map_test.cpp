#include "hatchway/maps/hatch_map.hpp"

#include <gtest/gtest.h>

#include <numeric>

using namespace hw;

namespace {

double tone_of(const Pixels& level)
{
    return 1.0 - std::accumulate(level.bytes.begin(), level.bytes.end(), 0.0) / (255.0 * level.bytes.size());
}

double ink_at(const Pixels& level, int x)
{
    return 1.0 - *level.at((x + level.width) % level.width, 0) / 255.0;
}

}  // namespace

TEST(hatch_map, every_level_is_half_as_wide_down_to_one_texel)
{
    const MapLevels map = make_hatch_map({.width_texels = 2048});
    ASSERT_EQ(map.levels.size(), 12u);
    for (std::size_t i = 0; i < map.levels.size(); ++i) {
        EXPECT_EQ(map.levels[i].width, 2048 >> i);
        EXPECT_EQ(map.levels[i].height, 1);
    }
}

TEST(hatch_map, lines_are_equally_far_apart_in_texels_at_every_level_that_holds_one)
{
    for (const Pixels& level : make_hatch_map({.spacing_texels = 8}).levels) {
        if (level.width < 8) continue;
        for (int x = 0; x < level.width; ++x)
            EXPECT_EQ(*level.at(x, 0), *level.at(x % 8, 0)) << level.width << " at " << x;
        EXPECT_GT(ink_at(level, 0), ink_at(level, 3));
    }
}

TEST(hatch_map, a_line_of_a_coarser_level_lies_exactly_on_every_second_one)
{
    const MapLevels map = make_hatch_map({});
    for (std::size_t i = 0; i + 1 < map.levels.size() && map.levels[i + 1].width >= 8; ++i)
        for (int line = 0; line < map.levels[i + 1].width; line += 8) {
            // Both texels beside a line's middle are equally dark, at both levels.
            EXPECT_EQ(ink_at(map.levels[i + 1], line), ink_at(map.levels[i + 1], line - 1));
            EXPECT_EQ(ink_at(map.levels[i], 2 * line), ink_at(map.levels[i], 2 * line - 1));
            EXPECT_GT(ink_at(map.levels[i], 2 * line), 0.5);
        }
}

TEST(hatch_map, the_tone_is_the_same_at_every_level_the_lowest_too)
{
    for (const double line : {0.4, 1.0, 1.25, 2.0, 3.5, 8.0})
        for (const Pixels& level : make_hatch_map({.spacing_texels = 8, .line_texels = line}).levels)
            EXPECT_NEAR(tone_of(level), line / 8.0, 0.6 / 255.0) << line << " at width " << level.width;
}

TEST(hatch_map, no_line_and_all_line_are_paper_and_ink)
{
    for (const Pixels& level : make_hatch_map({.line_texels = 0.0}).levels) EXPECT_EQ(tone_of(level), 0.0);
    for (const Pixels& level : make_hatch_map({.line_texels = 8.0}).levels) EXPECT_EQ(tone_of(level), 1.0);
}
