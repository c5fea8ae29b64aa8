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

TEST(stillness, is_not_ended_by_rounding_and_is_by_a_hair_s_breadth)
{
    const hw::Camera camera{.eye_world = {2.6, 2.6, 3.6}, .target_world = {2.0, 2.2, 2.8}};
    hw::Camera rounded = camera, moved = camera, wider = camera, plan = camera;
    rounded.eye_world.z += 5e-16;
    rounded.target_world.z -= 5e-16;
    moved.eye_world.x += 1e-9;
    wider.fov_deg += 0.01;
    plan.orthographic_height_m = 6.0;
    EXPECT_TRUE(are_alike(rounded, camera));
    for (const hw::Camera& other : {moved, wider, plan}) EXPECT_FALSE(are_alike(other, camera));
}

}  // namespace
