#include "hatchway/core/plain_text.hpp"

#include <gtest/gtest.h>

#include "hatchway/core/log.hpp"

using hw::plain_text;

TEST(plain_text, holds_nothing_that_a_terminal_obeys)
{
    EXPECT_EQ(plain_text("a\x1b]0;title\x07\r\n\tb\x7f"), "a\\x1b]0;title\\x07\\x0d\\n\\tb\\x7f");
    EXPECT_EQ(plain_text("\xc2\x9b[2J"), "\\x9b[2J") << "C1 as UTF-8";
    EXPECT_EQ(plain_text("\x9b[2J"), "\\x9b[2J") << "C1 as a byte";
    EXPECT_EQ(plain_text("\xe2\x80\xaegnp.exe"), "\\u202egnp.exe") << "right to left";
    EXPECT_EQ(plain_text(std::string_view("\0", 1)), "\\x00");
}

TEST(plain_text, holds_no_broken_utf8)
{
    EXPECT_EQ(plain_text("\xc3"), "\\xc3");
    EXPECT_EQ(plain_text("\xe2\x82"), "\\xe2\\x82");
    EXPECT_EQ(plain_text("\xc0\x9b"), "\\xc0\\x9b") << "overlong";
    EXPECT_EQ(plain_text("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "a surrogate";
    EXPECT_EQ(plain_text("\xff\xfe"), "\\xff\\xfe");
}

TEST(plain_text, keeps_names_of_all_languages)
{
    for (const char* name : {"S\xc3\xa4ule", "\xe6\x9f\xb1", "\xf0\x9f\x8f\x9b", "a b%s{}", ""})
        EXPECT_EQ(plain_text(name), name);
}

TEST(plain_text, of_json_stays_json)
{
    EXPECT_EQ(hw::plain_json("{\n \"a\x7f\xc2\x9b\xe2\x80\xae\": \"\xc3\xa4\"}\n"),
              "{\n \"a\\u007f\\u009b\\u202e\": \"\xc3\xa4\"}\n");
}

TEST(plain_text, is_what_the_log_and_results_are_written_in)
{
    testing::internal::CaptureStdout();
    hw::print_line("node \x1b[31m\nred");
    hw::print_lines("a\n\nb\x1b\n");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "node \\x1b[31m\\nred\na\n\nb\\x1b\n");
    testing::internal::CaptureStderr();
    hw::log_warning("node \x1b[31mred");
    const std::string log = testing::internal::GetCapturedStderr();
    EXPECT_NE(log.find("node \\x1b[31mred"), std::string::npos) << log;
}
