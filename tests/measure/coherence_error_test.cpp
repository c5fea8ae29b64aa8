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

CoherenceError errors_of(const InkPicture& before, const InkPicture& after, double true_motion)
{
    std::vector<CoherenceError> errors;
    const SeenTwice place{.before = {32.0, 32.0}, .after = {32.0 + true_motion, 32.0}};
    add_coherence(errors, before, after, std::span(&place, 1));
    return errors.at(0);
}

}  // namespace

TEST(coherence_error, ink_that_moves_with_the_surface_neither_flickers_nor_slides)
{
    const CoherenceError errors = errors_of(lines(0.0), lines(3.0), 3.0);
    EXPECT_LT(errors.flicker, 1e-6);
    EXPECT_LT(errors.tone, 1e-6);
    EXPECT_LT(errors.slide, 1e-6);
}

TEST(coherence_error, ink_that_stays_on_the_screen_slides_by_the_motion_of_the_surface)
{
    // Steps over two pixels see a tenth less of the slope of lines eight pixels apart, so a tenth more of a way.
    EXPECT_NEAR(errors_of(lines(0.0), lines(0.0), 0.5).slide, 0.5, 0.08);
    EXPECT_NEAR(errors_of(lines(0.0), lines(0.3), 0.0).slide, 0.3, 0.04);
}

TEST(coherence_error, ink_that_doubles_is_told_as_a_change_of_tone_and_not_as_sliding)
{
    const CoherenceError errors = errors_of(lines(0.0), lines(0.0, 2.0), 0.0);
    EXPECT_NEAR(errors.tone, 0.3, 0.04);
    EXPECT_LT(errors.slide, 0.05);
}

TEST(coherence_error, an_inked_place_that_goes_blank_flickers_by_its_ink)
{
    const InkPicture full{.width = 64, .height = 64, .ink = std::vector<float>(64 * 64, 0.8f)};
    const InkPicture blank{.width = 64, .height = 64, .ink = std::vector<float>(64 * 64, 0.0f)};
    const CoherenceError errors = errors_of(full, blank, 0.0);
    EXPECT_NEAR(errors.flicker, 0.8, 1e-6);
    EXPECT_NEAR(errors.pixel_flicker, 0.8, 1e-6);
    EXPECT_LT(errors.slide, 0.0);
}

TEST(coherence_error, pixels_flicker_where_their_mean_does_not)
{
    const CoherenceError errors = errors_of(lines(0.0), lines(4.0), 0.0);
    EXPECT_GT(errors.pixel_flicker, 0.3);
    EXPECT_LT(errors.tone, 0.05);
}

TEST(coherence_error, ink_on_a_bent_surface_does_not_slide_where_the_bend_is_told)
{
    SeenTwice place{.before = {32.0, 32.0}, .after = {32.0, 32.0}};
    place.bend_right = {0.01, 0.0};
    InkPicture after = lines(0.0);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            // Where the ink of this pixel was before: i + i * i / 100 steps from the middle is x.
            const double way = x + 0.5 - 32.0, i = (-1.0 + std::sqrt(std::max(1.0 + 0.04 * way, 0.0))) / 0.02;
            after.ink[y * 64 + x] = static_cast<float>(0.3 + 0.3 * std::sin(2.0 * 3.14159265358979 * (32.0 + i) / 8.0));
        }
    std::vector<CoherenceError> bent, straight;
    add_coherence(bent, lines(0.0), after, std::span(&place, 1));
    place.bend_right = {};
    add_coherence(straight, lines(0.0), after, std::span(&place, 1));
    EXPECT_LT(bent[0].slide, 0.02);
    EXPECT_LT(bent[0].pixel_flicker, 0.02);
    EXPECT_GT(straight[0].slide, 0.1);
}
