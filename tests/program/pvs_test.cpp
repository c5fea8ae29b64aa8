#include <gtest/gtest.h>

#include "tests/program/pvs_pictures.hpp"
#include "tests/program/run_program.hpp"

TEST(pvs, switching_it_off_changes_no_pixel_of_the_hall)
{
    const auto hall = hw::test::kContent / "levels" / "hall.level.json";
    const hw::test::PvsDifference difference = hw::test::compare_with_pvs(hall, "photoreal", 6);
    EXPECT_EQ(difference.unlike_pictures, 0) << difference.worst_view;
    EXPECT_LT(difference.drawn_share, 1.0) << "the PVS hides nothing at all";
}

TEST(pvs, the_range_of_depths_in_bytes_is_that_of_all_objects_so_it_changes_no_pixel_of_them)
{
    const auto hall = hw::test::kContent / "levels" / "hall.level.json";
    const hw::ImageKey bytes{"normal_depth", {{"format", std::string("rgba8")}}};
    const hw::test::PvsDifference difference = hw::test::compare_with_pvs(hall, "technical", 6, bytes);
    EXPECT_EQ(difference.unlike_pictures, 0) << difference.worst_view;
    EXPECT_LT(difference.drawn_share, 1.0) << "the PVS hides nothing at all";
    EXPECT_GT(difference.inked_pixels, 0);
}
