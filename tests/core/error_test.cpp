#include "hatchway/core/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

std::string message(hw::ErrorParts parts)
{
    return hw::Error(std::move(parts)).what();
}

}  // namespace

TEST(error, a_message_names_file_place_finding_and_what_is_allowed)
{
    EXPECT_EQ(message({.what = "stands 3", .file = "a.json", .pointer = "/b", .expected = "a text"}),
              "a.json: /b: stands 3; expected a text");
}

TEST(error, control_characters_of_names_are_written_out)
{
    const std::string name{"a\0b\nc\x1b[31md\x7f\xc2\x9b", 14};
    EXPECT_EQ(message({.what = "there is no \"" + name + '"', .file = "f\n.json", .pointer = "/\t", .expected = "\r"}),
              "f\\n.json: /\\t: there is no \"a\\x00b\\nc\\x1b[31md\\x7f\\x9b\"; expected \\x0d");
}

TEST(error, letters_beyond_ascii_stay)
{
    EXPECT_EQ(message({.what = "S\xc3\xa4ule \xc2\xa0"}), "S\xc3\xa4ule \xc2\xa0");
}

TEST(error, long_names_are_shortened_in_the_middle)
{
    const std::string text = message({.what = "there is no style \"" + std::string(5000, 'x') + "\" here"});
    EXPECT_LT(text.size(), 220u);
    EXPECT_TRUE(text.starts_with("there is no style \"xxx") && text.ends_with("xxx\" here")) << text;
    EXPECT_NE(text.find("..."), std::string::npos);
    EXPECT_LT(message({.what = "is missing", .file = std::string(5000, 'x')}).size(), 450u);
    std::string words;
    for (int i = 0; i < 5000; ++i) words += "x ";
    EXPECT_LT(message({.what = words}).size(), 1600u);
}

TEST(error, a_character_is_not_cut_in_two)
{
    std::string name;
    for (int i = 0; i < 1000; ++i) name += "\xe2\x82\xac";
    for (std::size_t before = 0; before < 3; ++before) {
        const std::string text = message({.what = std::string(before, 'a') + name});
        EXPECT_EQ(std::count(text.begin(), text.end(), '\xe2'), std::count(text.begin(), text.end(), '\xac'));
        EXPECT_EQ((text.size() - before - 3) % 3, 0u);
    }
}

TEST(error, the_parts_stay_as_they_were)
{
    EXPECT_EQ(hw::Error({.what = "a\nb"}).parts().what, "a\nb");
}
