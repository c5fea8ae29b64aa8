#include "hatchway/core/unique_names.hpp"

#include <gtest/gtest.h>

#include <set>

TEST(unique_names, get_the_first_number_that_is_free)
{
    hw::UniqueNames names({"object"});
    EXPECT_EQ(names.take("box"), "box");
    EXPECT_EQ(names.take("box_3"), "box_3");
    EXPECT_EQ(names.take("box"), "box_2");
    EXPECT_EQ(names.take("box"), "box_4");
    EXPECT_EQ(names.take("box_2"), "box_2_2");
    EXPECT_EQ(names.take("object"), "object_2");
    EXPECT_EQ(names.take(""), "");
    EXPECT_EQ(names.take(""), "_2");
}

/// From the first number on for each, this takes minutes.
TEST(unique_names, are_as_quick_for_a_hundred_thousand_of_one_name)
{
    hw::UniqueNames names;
    std::set<std::string> own;
    for (int i = 0; i < 100'000; ++i) own.insert(names.take("camera"));
    EXPECT_EQ(own.size(), 100'000u);
    EXPECT_TRUE(own.contains("camera_100000"));
}
