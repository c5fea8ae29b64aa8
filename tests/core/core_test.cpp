#include <gtest/gtest.h>

#include "core/glob.hpp"

using hw::glob_matches;

TEST(glob, a_lone_star_means_everything) { EXPECT_TRUE(glob_matches("*", "Hall/Column_01")); }
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
TEST(glob, hostile_patterns_end_soon)
{
    std::string pattern;
    for (int i = 0; i < 200; ++i) pattern += "*a";
    EXPECT_FALSE(glob_matches(pattern, std::string(5000, 'a') + "b"));
}
