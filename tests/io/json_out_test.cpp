#include "hatchway/io/json/out.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "hatchway/core/files/files.hpp"
#include "tests/temporary_folder.hpp"

using hw::JsonValue;

TEST(json_out, members_keep_their_order_and_plain_arrays_their_line)
{
    JsonValue value = JsonValue::object();
    value.set("zebra", 1).set("ant", JsonValue::array().push(1.5).push(true).push("x"));
    EXPECT_EQ(value.text(), "{\n  \"zebra\": 1,\n  \"ant\": [1.5, true, \"x\"]\n}\n");
}

TEST(json_out, arrays_of_arrays_have_a_line_each)
{
    JsonValue value = JsonValue::array();
    value.push(JsonValue::array().push(1).push(2)).push(JsonValue::array());
    EXPECT_EQ(value.text(), "[\n  [1, 2],\n  []\n]\n");
}

TEST(json_out, numbers_have_nine_digits_or_all)
{
    EXPECT_EQ(JsonValue(1.0 / 3.0).text(), "0.333333333\n");
    const double third = 1.0 / 3.0;
    EXPECT_EQ(nlohmann::json::parse(JsonValue::exact(third).text()).get<double>(), third);
    EXPECT_EQ(JsonValue(std::nan("")).text(), "null\n");
    EXPECT_EQ(JsonValue(INFINITY).text(), "null\n");
    EXPECT_EQ(JsonValue(std::uint64_t{1} << 40).text(), "1099511627776\n");
}

TEST(json_out, texts_are_escaped_and_bad_utf8_is_replaced)
{
    const std::string text = JsonValue("a\"\n\xff").text();
    EXPECT_EQ(nlohmann::json::parse(text).get<std::string>(), "a\"\n\xef\xbf\xbd");
}

TEST(json_out, equal_values_write_equal_files)
{
    const TemporaryFolder folder;
    const JsonValue value = JsonValue::object().set("a", JsonValue::array());
    hw::write_json(folder.path() / "a.json", value);
    EXPECT_EQ(hw::read_text_file(folder.path() / "a.json", 100), value.text());
}
