#include "measure/hatching/hatch_profile.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace hw;

namespace {

/// Lines drawn with a box filter one pixel wide; each second one has `second` of the width.
std::vector<double> ruled(double spacing_px, double line_px, double second = 1.0)
{
    std::vector<double> ink(512, 0.0);
    for (int line = -1; line * spacing_px < 520.0; ++line) {
        const double width = line_px * (line % 2 ? second : 1.0);
        const double from = line * spacing_px - 0.5 * width;
        const double to = from + width;
        for (std::size_t i = 0; i < ink.size(); ++i)
            ink[i] += std::max(0.0, std::min(to, i + 1.0) - std::max(from, static_cast<double>(i)));
    }
    return ink;
}

HatchSamples samples_of(const std::vector<double>& ink)
{
    HatchSamples samples;
    add_profile(samples, ink, {});
    return samples;
}

}  // namespace

TEST(hatch_profile, ideal_lines_have_no_error)
{
    const HatchSamples samples = samples_of(ruled(8.0, 1.25));
    EXPECT_GT(samples.spacing.size(), 50u);
    EXPECT_LT(absolute_quantile(samples.spacing, 1.0), 0.02);
    EXPECT_LT(absolute_quantile(samples.ink_spacing, 1.0), 0.02);
    EXPECT_LT(absolute_quantile(samples.width, 1.0), 0.01);
    EXPECT_LT(absolute_quantile(samples.tone, 1.0), 1e-9);
    EXPECT_LT(samples.low_energy.at(0), 1e-9);
}

TEST(hatch_profile, lines_a_quarter_too_far_apart_are_told_as_a_quarter)
{
    const HatchSamples samples = samples_of(ruled(10.0, 1.25));
    EXPECT_NEAR(mean_of(samples.spacing), 0.25, 0.01);
    EXPECT_NEAR(mean_of(samples.ink_spacing), 0.25, 0.01);
    EXPECT_NEAR(mean_of(samples.tone), 1.25 / 10.0 - 1.25 / 8.0, 0.003);
}

TEST(hatch_profile, lines_twice_as_wide_are_told_as_twice_the_width_and_the_tone)
{
    const HatchSamples samples = samples_of(ruled(8.0, 2.5));
    EXPECT_NEAR(mean_of(samples.width), 1.0, 0.01);
    EXPECT_NEAR(mean_of(samples.tone), 1.25 / 8.0, 0.001);
}

TEST(hatch_profile, weak_second_lines_are_counted_by_their_ink)
{
    // Lines of 1 and 0.2 six pixels apart: 2 * 6 * 1 / 1.2 = 10 px by ink, and 12 px when weak ones are none.
    const HatchSamples samples = samples_of(ruled(6.0, 1.25, 0.2));
    EXPECT_NEAR(mean_of(samples.ink_spacing), 10.0 / 8.0 - 1.0, 0.02);
    EXPECT_NEAR(mean_of(samples.spacing), 12.0 / 8.0 - 1.0, 0.02);
}

TEST(hatch_profile, even_gray_has_its_tone_and_neither_lines_nor_contrast)
{
    const HatchSamples samples = samples_of(std::vector<double>(512, 1.25 / 8.0));
    EXPECT_TRUE(samples.spacing.empty());
    EXPECT_EQ(absolute_quantile(samples.contrast, 1.0), 0.0);
    EXPECT_LT(absolute_quantile(samples.tone, 1.0), 1e-9);
}

TEST(hatch_profile, of_nothing_there_is_no_figure_least_of_all_a_perfect_one)
{
    EXPECT_TRUE(std::isnan(absolute_quantile({}, 0.5)));
    EXPECT_TRUE(std::isnan(root_mean_square({})));
    EXPECT_TRUE(std::isnan(mean_of({})));
}

TEST(hatch_profile, a_beat_of_lines_that_pixels_skip_is_told_as_energy_below_the_line_frequency)
{
    std::vector<double> beat(512);
    for (std::size_t i = 0; i < beat.size(); ++i) beat[i] = 0.15 + 0.1 * std::sin(2.0 * 3.14159265358979 * i / 128.0);
    // A sine of amplitude 0.1 has an RMS of 0.0707; a box of an eighth of its period keeps sin(pi/8)/(pi/8) = 0.974 of
    // it.
    EXPECT_NEAR(samples_of(beat).low_energy.at(0), 0.0707 * 0.974, 0.006);
    EXPECT_LT(samples_of(ruled(8.0, 1.25)).low_energy.at(0), 0.001);
}
