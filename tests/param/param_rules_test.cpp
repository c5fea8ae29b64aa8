#include "hatchway/param/param_rules.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

enum class Tone { plain, shaded };
constexpr std::array<std::string_view, 2> kTones{"plain", "shaded"};
constexpr std::array<std::string_view, 2> kTwins{"plain", "plain"};

}  // namespace

TEST(param_rules, good_parameters_break_none)
{
    hw::ParamRules rules;
    float width = 1.0f;
    int count = 3;
    bool flag = false;
    glm::vec3 colour(0.5f);
    Tone tone = Tone::shaded;
    rules.real({"width_px", "Width."}, width, 0.0f, 4.0f);
    rules.whole({"count_2", "Count."}, count, 1, 3);
    rules.flag({"is_on", "On."}, flag);
    rules.colour({"colour", "Colour."}, colour);
    rules.choice({"tone", "Tone."}, tone, kTones);
    EXPECT_THAT(rules.broken(), IsEmpty());
}

TEST(param_rules, names_are_lower_snake_case_once_and_not_those_of_level_files)
{
    hw::ParamRules rules;
    bool flag = false;
    for (const char* name : {"lineWidth", "2d", "line-width", "ends_", "a__b", "", "plugin", "like"})
        rules.flag({name, "Help."}, flag);
    EXPECT_EQ(rules.broken().size(), 8u);
    rules.flag({"twice", "Help."}, flag);
    rules.flag({"twice", "Help."}, flag);
    EXPECT_THAT(rules.broken().back(), HasSubstr("\"twice\" is visited twice"));
    rules.flag({"mute", ""}, flag);
    EXPECT_THAT(rules.broken().back(), HasSubstr("help"));
}

TEST(param_rules, ranges_go_upwards_and_hold_the_default)
{
    const float infinity = std::numeric_limits<float>::infinity();
    hw::ParamRules rules;
    float value = 5.0f;
    int whole = 5;
    glm::vec3 colour(2.0f);
    Tone tone = Tone::plain;
    rules.real({"a", "Help."}, value, 4.0f, 1.0f);
    rules.real({"b", "Help."}, value, 0.0f, infinity);
    rules.real({"c", "Help."}, value, 0.0f, 4.0f);
    rules.whole({"d", "Help."}, whole, 0, 4);
    rules.colour({"e", "Help."}, colour);
    rules.choice({"f", "Help."}, tone, kTwins);
    EXPECT_THAT(rules.broken(), ElementsAre(HasSubstr("range 4 to 1"), HasSubstr("inf"), HasSubstr("default 5"),
                                            HasSubstr("default 5"), HasSubstr("default 2"), HasSubstr("two choices")));
}
