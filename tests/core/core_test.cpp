#include <gtest/gtest.h>

#include "hatchway/core/glob.hpp"

using hw::glob_matches;

TEST(glob, a_lone_star_means_everything)
{
    EXPECT_TRUE(glob_matches("*", "Hall/Column_01"));
}
TEST(glob, a_star_stops_at_a_slash)
{
    EXPECT_TRUE(glob_matches("Hall/*", "Hall/Column_01"));
    EXPECT_FALSE(glob_matches("Hall/*", "Hall/Column_01/Base"));
    EXPECT_TRUE(glob_matches("Hall/**", "Hall/Column_01/Base"));
}
TEST(glob, a_class_takes_one_character)
{
    EXPECT_TRUE(glob_matches("Column_0[1-3]", "Column_02"));
    EXPECT_FALSE(glob_matches("Column_0[1-3]", "Column_04"));
    EXPECT_TRUE(glob_matches("Column_0[!1-3]", "Column_04"));
}
TEST(glob, a_class_that_is_never_closed_is_a_fault)
{
    for (const char* pattern : {"[", "Column_[0-", "A[0-9]/[!x"}) EXPECT_NE(hw::glob_fault(pattern), "") << pattern;
    for (const char* pattern : {"", "*", "Column_0[1-3]", "A]", "[!ab]?"})
        EXPECT_EQ(hw::glob_fault(pattern), "") << pattern;
}
TEST(glob, hostile_patterns_end_soon)
{
    std::string pattern;
    for (int i = 0; i < 200; ++i) pattern += "*a";
    EXPECT_FALSE(glob_matches(pattern, std::string(5000, 'a') + "b"));
}
