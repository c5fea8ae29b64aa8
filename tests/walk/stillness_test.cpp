#include "hatchway/walk/stillness.hpp"

#include <gmock/gmock.h>

#include <vector>

namespace {

using hw::FrameWork;

/// What the frames do, one each eighth of a second; something changes in those where `changes` says so.
std::vector<FrameWork> works(const std::vector<bool>& changes)
{
    std::vector<FrameWork> all;
    hw::Stillness state;
    for (std::size_t i = 0; i < changes.size(); ++i) {
        state = hw::after_moment(state, changes[i], 10.0 + 0.125 * static_cast<double>(i));
        all.push_back(state.work);
    }
    return all;
}

TEST(stillness, draws_one_sharp_frame_after_a_third_of_a_second_and_then_none)
{
    EXPECT_THAT(works({true, false, false, false, false, false}),
                testing::ElementsAre(FrameWork::paced, FrameWork::paced, FrameWork::paced, FrameWork::sharp,
                                     FrameWork::nothing, FrameWork::nothing));
}

TEST(stillness, counts_from_the_last_change)
{
    EXPECT_THAT(works({true, false, false, true, false, false}), testing::Each(FrameWork::paced));
}

TEST(stillness, ends_with_the_first_change)
{
    const std::vector<FrameWork> all = works({true, false, false, false, false, true, false});
    EXPECT_EQ(all[4], FrameWork::nothing);
    EXPECT_EQ(all[5], FrameWork::paced);
    EXPECT_EQ(all[6], FrameWork::paced);
}

}  // namespace
