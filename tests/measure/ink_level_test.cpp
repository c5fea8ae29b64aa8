#include "measure/hatching/ink_level.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hatchway/maps/ink_map.hpp"
#include "hatchway/maps/stroke_drawing.hpp"

using namespace hw;

namespace {

/// Level strokes in a map of 128 texels, turned by whole steps so that they meet themselves at the borders.
Pixels strokes(double pen_texels, int rise, int count = 6)
{
    InkPlane plane(128, 128);
    for (int i = 0; i < count; ++i) {
        const double y = (i + 0.3) / count;
        draw_stroke(plane, {.points = {{0.0, y}, {1.0, y + rise}}}, pen_texels);
    }
    return level_of(plane);
}

}  // namespace

TEST(ink_level, the_width_of_strokes_is_that_of_the_pen_level_and_slanting)
{
    for (const double pen : {1.6, 3.0, 5.0})
        for (const int rise : {0, 1})
            EXPECT_NEAR(ink_level_figures(strokes(pen, rise)).stroke_texels, pen, 0.12 * pen) << pen;
}

TEST(ink_level, strokes_of_half_the_width_are_told_as_half)
{
    const double wide = ink_level_figures(strokes(4.0, 0)).stroke_texels;
    EXPECT_NEAR(ink_level_figures(strokes(2.0, 0)).stroke_texels / wide, 0.5, 0.05);
}

TEST(ink_level, tone_is_the_share_of_ink)
{
    EXPECT_NEAR(ink_level_figures(strokes(3.0, 0)).tone, 6 * 3.0 / 128.0, 0.004);
}

TEST(ink_level, minimum_filtering_is_told_as_ink_that_doubles_and_strokes_that_widen)
{
    const Pixels finest = strokes(1.6, 0, 4);
    const InkLevelFigures before = ink_level_figures(finest);
    const InkLevelFigures after = ink_level_figures(filtered_by_minimum(finest, 1.0).levels[3]);
    EXPECT_GT(after.tone, 3.0 * before.tone);
}

TEST(ink_level, box_filtering_is_told_as_contrast_that_is_lost)
{
    const Pixels finest = strokes(1.6, 0, 4);
    EXPECT_LT(ink_level_figures(filtered_by_mean(finest, 1.0).levels[3]).contrast,
              0.35 * ink_level_figures(finest).contrast);
}

TEST(ink_level, even_gray_has_a_tone_and_no_stroke)
{
    const Pixels gray{.width = 16, .height = 16, .channels = 1, .bytes = std::vector<std::uint8_t>(256, 204)};
    EXPECT_NEAR(ink_level_figures(gray).tone, 0.2, 1e-6);
    EXPECT_EQ(ink_level_figures(gray).stroke_texels, 0.0);
    EXPECT_EQ(ink_level_figures(gray).contrast, 0.0);
}
