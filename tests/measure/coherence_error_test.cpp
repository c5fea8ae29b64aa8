#include "measure/hatching/coherence_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace hw;

namespace {

/// Soft upright lines 8 pixels apart, moved to the right by `shift`; all ink times `strength`.
InkPicture lines(double shift, double strength = 1.0)
{
    InkPicture picture{.width = 64, .height = 64, .ink = std::vector<float>(64 * 64)};
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            picture.ink[y * 64 + x] =
                static_cast<float>(strength * (0.3 + 0.3 * std::sin(2.0 * 3.14159265358979 * (x + 0.5 - shift) / 8.0)));
    return picture;
}

CoherenceErrors errors_of(const InkPicture& before, const InkPicture& after, double true_motion)
{
    CoherenceErrors errors;
    const SeenTwice place{.before = {32.0, 32.0}, .after = {32.0 + true_motion, 32.0}};
    add_coherence(errors, before, after, std::span(&place, 1));
    return errors;
}

}  // namespace

TEST(coherence_error, ink_that_moves_with_the_surface_neither_flickers_nor_slides)
{
    const CoherenceErrors errors = errors_of(lines(0.0), lines(3.0), 3.0);
    EXPECT_LT(errors.flicker.at(0), 1e-6);
    EXPECT_LT(errors.tone.at(0), 1e-6);
    EXPECT_LT(errors.slide.at(0), 1e-6);
}

TEST(coherence_error, ink_that_stays_on_the_screen_slides_by_the_motion_of_the_surface)
{
    // Steps over two pixels see a tenth less of the slope of lines eight pixels apart, so a tenth more of a way.
    EXPECT_NEAR(errors_of(lines(0.0), lines(0.0), 0.5).slide.at(0), 0.5, 0.08);
    EXPECT_NEAR(errors_of(lines(0.0), lines(0.3), 0.0).slide.at(0), 0.3, 0.04);
}

TEST(coherence_error, ink_that_doubles_is_told_as_a_change_of_tone_and_not_as_sliding)
{
    const CoherenceErrors errors = errors_of(lines(0.0), lines(0.0, 2.0), 0.0);
    EXPECT_NEAR(errors.tone.at(0), 0.3, 0.04);
    EXPECT_LT(errors.slide.at(0), 0.05);
}

TEST(coherence_error, an_inked_place_that_goes_blank_flickers_by_its_ink)
{
    const InkPicture full{.width = 64, .height = 64, .ink = std::vector<float>(64 * 64, 0.8f)};
    const InkPicture blank{.width = 64, .height = 64, .ink = std::vector<float>(64 * 64, 0.0f)};
    const CoherenceErrors errors = errors_of(full, blank, 0.0);
    EXPECT_NEAR(errors.flicker.at(0), 0.8, 1e-6);
    EXPECT_TRUE(errors.slide.empty());
}
