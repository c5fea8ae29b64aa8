// Random eyes in every scene, twelve or, with HATCHWAY_WHOLE_CORPORA, fifty: identical bytes in photoreal; in ink,
// lines are drawn a little over their faces and may leak through a wall's edge, so a few in ten thousand of the inked
// pixels may differ.
#include <gtest/gtest.h>

#include <iostream>

#include "tests/program/pvs_pictures.hpp"
#include "tests/shared_data.hpp"

namespace {

const int kEyes = hw::test::is_set("HATCHWAY_WHOLE_CORPORA") ? 50 : 12;
constexpr double kLeakedShare = 1e-4;

}  // namespace

TEST(pvs_slow, switching_it_off_changes_no_pixel_in_photoreal)
{
    for (const auto& scene : hw::test::pvs_scenes()) {
        const hw::test::PvsDifference difference = hw::test::compare_with_pvs(scene, "photoreal", kEyes);
        std::cout << scene.filename() << " draws " << 100.0 * difference.drawn_share << " % of the triangles\n";
        EXPECT_EQ(difference.unlike_pictures, 0) << scene << ' ' << difference.worst_view;
    }
}

TEST(pvs_slow, switching_it_off_leaks_hardly_a_line_in_ink)
{
    for (const auto& scene : hw::test::pvs_scenes()) {
        const hw::test::PvsDifference difference = hw::test::compare_with_pvs(scene, "pen_and_ink", kEyes);
        std::cout << scene.filename() << ' ' << difference.unlike_pictures << " pictures differ, in "
                  << difference.unlike_pixels << " of " << difference.inked_pixels << " inked pixels\n";
        EXPECT_LE(difference.unlike_pixels, kLeakedShare * difference.inked_pixels)
            << scene << ' ' << difference.worst_view;
        EXPECT_GT(difference.inked_pixels, 5'000) << scene;
    }
}
