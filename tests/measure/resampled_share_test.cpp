#include "measure/resampled_share.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using hw::measure::resampled_share;
using Parts = std::vector<std::pair<double, double>>;

TEST(resampled_share, equal_parts_leave_no_doubt)
{
    const auto range = resampled_share(Parts(10, {1.0, 4.0}));
    EXPECT_EQ(range.low, 0.25);
    EXPECT_EQ(range.high, 0.25);
}

TEST(resampled_share, of_parts_that_are_all_or_nothing_the_interval_is_the_binomial_one)
{
    Parts parts(50, {0.0, 1.0});
    parts.insert(parts.end(), 50, {1.0, 1.0});
    const auto range = resampled_share(parts);
    EXPECT_NEAR(range.low, 0.5 - 1.96 * 0.05, 0.015);
    EXPECT_NEAR(range.high, 0.5 + 1.96 * 0.05, 0.015);
}

TEST(resampled_share, few_parts_leave_more_doubt_than_many)
{
    const Parts few{{0.0, 1.0}, {1.0, 1.0}, {0.5, 1.0}};
    Parts many;
    for (int i = 0; i < 30; ++i) many.insert(many.end(), few.begin(), few.end());
    const auto wide = resampled_share(few), narrow = resampled_share(many);
    EXPECT_GT(wide.high - wide.low, 3.0 * (narrow.high - narrow.low));
}

TEST(resampled_share, of_nothing_there_is_none)
{
    EXPECT_TRUE(std::isnan(resampled_share({}).low));
    EXPECT_TRUE(std::isnan(resampled_share(Parts(3, {0.0, 0.0})).high));
}
