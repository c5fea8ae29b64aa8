#include "hatchway/maps/tonal_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hatchway/maps/stroke_drawing.hpp"

using namespace hw;

namespace {

const MapLevels& tonal_map()
{
    static const MapLevels map = make_tonal_map({.size_texels = 128});
    return map;
}

float ink_at(const MapLevels& map, std::size_t level, int tone, int x, int y)
{
    const Pixels& pixels = map.levels[level];
    return 1.0f - *pixels.at(tone * pixels.height + x, y) / 255.0f;
}

double tone_of(const MapLevels& map, std::size_t level, int tone)
{
    const int size = map.levels[level].height;
    double sum = 0.0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) sum += ink_at(map, level, tone, x, y);
    return sum / (size * size);
}

}  // namespace

TEST(tonal_map, tones_stand_side_by_side_at_every_level)
{
    for (const Pixels& level : tonal_map().levels) EXPECT_EQ(level.width, 6 * level.height);
    EXPECT_EQ(tonal_map().levels.back().height, 1);
}

TEST(tonal_map, every_tone_has_its_coverage_at_every_level)
{
    double squares = 0.0;
    int count = 0;
    for (std::size_t level = 0; level < tonal_map().levels.size(); ++level) {
        for (int tone = 0; tone < 6; ++tone) {
            const double error = tone_of(tonal_map(), level, tone) - (tone + 1) / 6.0;
            EXPECT_LT(std::abs(error), 0.06) << "level " << level << ", tone " << tone;
            squares += error * error;
            ++count;
        }
    }
    EXPECT_LT(std::sqrt(squares / count), 0.04);
}

TEST(tonal_map, every_darker_tone_holds_all_ink_of_every_lighter_one_at_every_level)
{
    for (std::size_t level = 0; level < tonal_map().levels.size(); ++level)
        for (int light = 0; light < 6; ++light)
            for (int dark = light + 1; dark < 6; ++dark)
                for (int y = 0; y < tonal_map().levels[level].height; ++y)
                    for (int x = 0; x < tonal_map().levels[level].height; ++x)
                        ASSERT_GE(ink_at(tonal_map(), level, dark, x, y), ink_at(tonal_map(), level, light, x, y))
                            << "level " << level << ", tones " << light << " and " << dark << " at " << x << ", " << y;
}

TEST(tonal_map, every_finer_level_holds_the_strokes_of_every_coarser_one_in_every_tone_as_dark)
{
    // A texel that is all ink lies in the middle of a stroke; the same place must be inked, within a pen, at finer
    // levels.
    const std::size_t level_count = tonal_map().levels.size();
    for (std::size_t fine = 0; fine < level_count; ++fine)
        for (std::size_t level = fine + 1; level < level_count && tonal_map().levels[level].height >= 16; ++level)
            for (int light = 0; light < 5; ++light)
                for (int dark = light; dark < 5; ++dark) {
                    const int coarse = tonal_map().levels[level].height;
                    const int times = tonal_map().levels[fine].height / coarse;
                    const int size = coarse * times;
                    for (int y = 0; y < coarse; ++y)
                        for (int x = 0; x < coarse; ++x) {
                            if (ink_at(tonal_map(), level, light, x, y) < 0.999f) continue;
                            float most = 0.0f;
                            for (int j = -1; j <= times; ++j)
                                for (int i = -1; i <= times; ++i)
                                    most = std::max(most, ink_at(tonal_map(), fine, dark, (times * x + i + size) % size,
                                                                 (times * y + j + size) % size));
                            ASSERT_GT(most, 0.5f) << "levels " << fine << " and " << level << ", tones " << light
                                                  << " and " << dark << " at " << x << ", " << y;
                        }
                }
}

TEST(tonal_map, priorities_are_spread_evenly_at_every_level_that_holds_strokes)
{
    const MapLevels map = make_priority_map({.size_texels = 128, .tones = 16});
    for (const Pixels& level : map.levels) {
        if (level.width < 16) continue;
        for (const double tone : {0.1, 0.25, 0.5, 0.75, 0.9}) {
            const double threshold = 255.0 * (1.0 - tone);  // a texel is ink where its priority lies above it
            const auto inked = std::ranges::count_if(level.bytes, [&](int paper) { return 255 - paper > threshold; });
            EXPECT_NEAR(static_cast<double>(inked) / static_cast<double>(level.bytes.size()), tone, 0.02)
                << level.width;
        }
    }
}

TEST(tonal_map, a_ramp_from_paper_to_ink_is_shown_within_four_hundredths_and_never_turns_back)
{
    for (std::size_t level = 0; level < tonal_map().levels.size(); ++level) {
        double squares = 0.0;
        double last = 0.0;
        for (int step = 0; step <= 60; ++step) {
            // As the shader blends: the two tones beside the one that is wanted; paper below the lightest.
            const double index = 6.0 * step / 60.0 - 1.0;
            const int lighter = static_cast<int>(std::floor(index));
            const double light = lighter < 0 ? 0.0 : tone_of(tonal_map(), level, lighter);
            const double dark = tone_of(tonal_map(), level, std::min(lighter + 1, 5));
            const double shown = light + (index - lighter) * (dark - light);
            EXPECT_GE(shown, last - 1e-9) << "level " << level << ", step " << step;
            last = shown;
            squares += (shown - step / 60.0) * (shown - step / 60.0);
        }
        EXPECT_LE(std::sqrt(squares / 61.0), 0.04) << "level " << level;
        EXPECT_NEAR(last, 1.0, 0.01);
    }
}

TEST(tonal_map, equal_descriptions_give_equal_bytes_and_another_seed_gives_others)
{
    const MapLevels again = make_tonal_map({.size_texels = 128});
    EXPECT_EQ(again.levels[0].bytes, tonal_map().levels[0].bytes);
    EXPECT_NE(make_tonal_map({.size_texels = 128, .seed = 2}).levels[0].bytes, tonal_map().levels[0].bytes);
}
