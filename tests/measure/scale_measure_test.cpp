// What `measure scale` reports, on numbers and pictures whose answer is known.
#include <gtest/gtest.h>

#include <array>

#include "hatchway/core/pixels.hpp"
#include "measure/log_slope.hpp"
#include "measure/picture_difference.hpp"

namespace hw {
namespace {

constexpr std::array<double, 4> kTriangles{2.6e5, 5.1e5, 1.0e6, 2.0e6};

std::array<double, 4> times(double (*of)(double triangles))
{
    std::array<double, 4> result{};
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = of(kTriangles[i]);
    return result;
}

TEST(scale_measure, work_that_grows_with_the_square_has_a_slope_of_two)
{
    EXPECT_NEAR(measure::log_slope(kTriangles, times([](double n) { return 3e-9 * n * n; })), 2.0, 1e-9);
}

TEST(scale_measure, work_that_follows_the_whole_level_has_a_slope_of_one_and_constant_work_has_none)
{
    EXPECT_NEAR(measure::log_slope(kTriangles, times([](double n) { return 0.01 * n; })), 1.0, 1e-9);
    EXPECT_NEAR(measure::log_slope(kTriangles, times([](double) { return 7.5; })), 0.0, 1e-9);
}

TEST(scale_measure, one_size_at_which_rows_fall_apart_shows_in_the_slope)
{
    std::array<double, 4> frame_ms{10.0, 10.0, 10.0, 10.0};
    frame_ms.back() = 80.0;
    // By hand, for sizes that double: 3 log2(8) * 1.5 / 5 = 0.9 a doubling.
    EXPECT_NEAR(measure::log_slope(std::array{1.0, 2.0, 4.0, 8.0}, frame_ms), 0.9, 1e-9);
}

TEST(scale_measure, every_pixel_that_differs_counts_once_however_little)
{
    Pixels a{.width = 8, .height = 4, .channels = 3, .bytes = std::vector<std::uint8_t>(96, 100)};
    Pixels b = a;
    EXPECT_EQ(measure::unlike_share(a, b), 0.0);
    b.bytes[0] = 101;  // two channels of the first pixel
    b.bytes[1] = 0;
    b.bytes[95] = 99;  // and the last pixel
    EXPECT_DOUBLE_EQ(measure::unlike_share(a, b), 2.0 / 32.0);
}

}  // namespace
}  // namespace hw
