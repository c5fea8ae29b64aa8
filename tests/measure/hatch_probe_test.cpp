#include "measure/hatching/hatch_probe.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hatchway/gl/context.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "measure/hatching/hatch_profile.hpp"

using namespace hw;

namespace {

constexpr double kTone = 1.25 / 8.0;

class hatch_on_a_plane : public testing::Test {
 protected:
    ~hatch_on_a_plane() override { EXPECT_TRUE(context_->take_errors().empty()); }

    HatchSamples samples(LevelChoice choice, double angle_deg, double distance)
    {
        const Pixels picture = probe_.draw({false, angle_deg, distance}, choice, {16, 512}, 8.0).pixels;
        HatchSamples result;
        add_profile(result, column_ink(picture, 8), {});
        return result;
    }

    std::unique_ptr<Context> context_ = make_headless_context();
    HatchProbe probe_{*context_};
};

}  // namespace

TEST_F(hatch_on_a_plane, keeps_spacing_and_tone_from_the_finest_level_to_the_coarsest_at_all_angles)
{
    for (const double distance : {1.0, 3.3, 20.0, 256.0})
        for (const double angle : {0.0, 45.0, 80.0}) {
            const HatchSamples s = samples(LevelChoice::ours, angle, distance);
            SCOPED_TRACE(testing::Message() << angle << " degrees, distance " << distance);
            EXPECT_LE(absolute_quantile(s.ink_spacing, 0.5), 0.07);
            EXPECT_LE(absolute_quantile(s.ink_spacing, 0.99), 0.15);
            EXPECT_LE(absolute_quantile(s.spacing, 1.0), 0.5);
            EXPECT_LE(root_mean_square(s.tone), 0.03);
        }
}

TEST_F(hatch_on_a_plane, nearer_than_the_first_level_and_farther_than_the_last_the_lines_go_on)
{
    for (const double distance : {1e-3, 0.3, 700.0, 3e4}) {
        const HatchSamples s = samples(LevelChoice::ours, 0.0, distance);
        EXPECT_GT(s.width.size(), 40u) << distance;
        EXPECT_LE(std::abs(mean_of(s.tone)), 0.01) << distance;
    }
}

TEST_F(hatch_on_a_plane, grazing_at_eighty_five_degrees_it_keeps_its_tone)
{
    for (const double distance : {1.0, 16.0, 181.0})
        EXPECT_LE(std::abs(mean_of(samples(LevelChoice::ours, 85.0, distance).tone)), 0.01) << distance;
}

TEST_F(hatch_on_a_plane, ordinary_mips_lose_the_contrast_that_ours_keep)
{
    const double native = mean_of(samples(LevelChoice::ours, 0.0, 1.0).contrast);
    EXPECT_GE(mean_of(samples(LevelChoice::ours, 60.0, 16.0).contrast), 0.8 * native);
    EXPECT_LE(mean_of(samples(LevelChoice::ordinary_mips, 60.0, 16.0).contrast), 0.3 * native);
}

TEST_F(hatch_on_a_plane, without_mips_lines_that_pixels_skip_give_energy_below_the_line_frequency)
{
    const double ours = root_mean_square(samples(LevelChoice::ours, 60.0, 45.0).low_energy);
    const double without = root_mean_square(samples(LevelChoice::no_mips, 60.0, 45.0).low_energy);
    EXPECT_LE(ours, 0.03);
    EXPECT_GE(without, 1.5 * ours);
}
