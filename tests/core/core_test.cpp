#include <gtest/gtest.h>

#include "hatchway/core/budget.hpp"
#include "hatchway/core/error.hpp"
#include "hatchway/core/glob.hpp"
#include "hatchway/core/limits.hpp"

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
TEST(glob, runs_that_follow_each_other_are_the_deeper_one)
{
    EXPECT_TRUE(glob_matches("Hall/***/Base", "Hall/a/b/Base"));
    EXPECT_FALSE(glob_matches("Hall/?*/Base", "Hall/a/b/Base"));
    EXPECT_TRUE(glob_matches("**?*e", "Hall/a/Base"));
    EXPECT_FALSE(glob_matches("a?", "a"));
    EXPECT_TRUE(glob_matches("a*b*c", "aXbXbXc"));
    EXPECT_FALSE(glob_matches("a*b*c", "aXbXbXcd"));
}
TEST(glob, steps_are_taken_from_a_budget)
{
    std::uint64_t left = 1000;
    EXPECT_TRUE(hw::Glob("Hall/*").matches("Hall/Column", left));
    EXPECT_LT(left, 1000u);
    EXPECT_GT(left, 900u);
    left = 5;
    EXPECT_FALSE(hw::Glob("Hall/*").matches("Hall/Column", left)) << "it ran out";
    EXPECT_EQ(left, 0u);
}
TEST(glob, hostile_patterns_end_soon)
{
    std::string pattern;
    for (int i = 0; i < 200; ++i) pattern += "*a";
    EXPECT_FALSE(glob_matches(pattern, std::string(5000, 'a') + "b"));
}
TEST(glob, follows_a_text_through_patterns_of_any_length)
{
    for (const std::size_t length : {63, 64, 65, 128, 1000}) {
        const std::string text(length, 'a');
        EXPECT_TRUE(glob_matches(text, text)) << length;
        EXPECT_TRUE(glob_matches("**" + text + "**", "b/" + text + "/b")) << length;
        EXPECT_TRUE(glob_matches(text + "*?", text + "ab")) << length;
        EXPECT_FALSE(glob_matches(text + "*?", text)) << length;
        EXPECT_FALSE(glob_matches(text, text + "a")) << length;
    }
}

TEST(budget, says_which_limit_ran_out_and_how_to_raise_it)
{
    hw::Budget budget;
    const std::uint64_t all = budget.left(hw::Cost::objects);
    EXPECT_EQ(all, hw::limits::kMaxObjects);
    budget.spend(hw::Cost::objects, all - 1, "a.glb", "/nodes/3");
    EXPECT_EQ(budget.left(hw::Cost::objects), 1u);
    EXPECT_EQ(budget.left(hw::Cost::nodes), hw::limits::kMaxNodes) << "each kind has a limit of its own";
    try {
        budget.spend(hw::Cost::objects, 2, "a.glb", "/nodes/4");
        FAIL();
    } catch (const hw::Error& error) {
        EXPECT_EQ(error.parts().what, "too many objects");
        EXPECT_EQ(error.parts().pointer, "/nodes/4");
        EXPECT_NE(error.parts().expected.find("--budget-factor 2"), std::string::npos);
    }
}
TEST(budget, a_factor_raises_every_limit)
{
    hw::Budget::factor() = 3.0;
    EXPECT_EQ(hw::Budget().left(hw::Cost::nodes), 3 * hw::limits::kMaxNodes);
    hw::Budget::factor() = 1.0;
}
