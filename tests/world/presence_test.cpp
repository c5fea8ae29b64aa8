#include "hatchway/world/presence.hpp"

#include <gtest/gtest.h>

namespace {

using hw::changes_after;

TEST(presence, changes_until_the_later_end_of_its_time)
{
    EXPECT_TRUE(changes_after({.time = hw::Ramp{1.0f, 3.0f}}, 0.0));
    EXPECT_TRUE(changes_after({.time = hw::Ramp{3.0f, 1.0f}}, 2.9));
    EXPECT_FALSE(changes_after({.time = hw::Ramp{1.0f, 3.0f}}, 3.0));
}

TEST(presence, does_not_change_without_a_time_or_where_it_is_0_at_all_times)
{
    EXPECT_FALSE(changes_after({.height = hw::Ramp{0.0f, 1.0f}}, 0.0));
    EXPECT_FALSE(changes_after({.constant = 0.0f, .time = hw::Ramp{1.0f, 3.0f}}, 0.0));
}

TEST(presence, over_a_step_in_time_changes_until_the_step)
{
    const hw::PresenceField step{.time = hw::Ramp{2.0f, 2.0f}};
    EXPECT_TRUE(changes_after(step, 1.9));
    EXPECT_FALSE(changes_after(step, 2.0));
    EXPECT_NE(presence_at(step, 0.0f, 1.9), presence_at(step, 0.0f, 2.0));
}

}  // namespace
