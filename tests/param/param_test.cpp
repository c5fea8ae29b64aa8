#include <gtest/gtest.h>

#include "hatchway/core/error.hpp"
#include "hatchway/param/param_reader.hpp"

namespace {

hw::ParamSettings one_setting(const std::string& name, hw::ParamValue value)
{
    return {{name, {std::move(value), "/styles/assumed/" + name}}};
}

std::string refusal(const std::function<void()>& action)
{
    try {
        action();
    } catch (const hw::Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(param_reader, a_value_in_range_is_taken)
{
    float width = 1.0f;
    const auto settings = one_setting("line_width_px", 2.5);
    hw::ParamReader reader(settings, "a.json");
    reader.real({"line_width_px", ""}, width, 0.1f, 16.0f);
    EXPECT_FLOAT_EQ(width, 2.5f);
}

TEST(param_reader, a_value_out_of_range_names_file_pointer_and_range)
{
    float width = 1.0f;
    const auto settings = one_setting("line_width_px", 99.0);
    hw::ParamReader reader(settings, "a.json");
    const std::string message = refusal([&] { reader.real({"line_width_px", ""}, width, 0.5f, 16.0f); });
    EXPECT_EQ(message, "a.json: /styles/assumed/line_width_px: line_width_px is 99; expected a number from 0.5 to 16");
    EXPECT_FLOAT_EQ(width, 1.0f);
}

TEST(param_reader, an_unknown_parameter_is_refused_with_the_names_that_exist)
{
    float width = 1.0f;
    const auto settings = one_setting("line_widht_px", 1.0);
    hw::ParamReader reader(settings, "a.json");
    reader.real({"line_width_px", ""}, width, 0.5f, 16.0f);
    const std::string message = refusal([&] { reader.refuse_unknown(); });
    EXPECT_NE(message.find("\"line_widht_px\""), std::string::npos);
    EXPECT_NE(message.find("one of: line_width_px"), std::string::npos);
}

TEST(param_reader, a_colour_has_six_hexadecimal_digits)
{
    glm::vec3 colour(0.0f);
    EXPECT_TRUE(hw::parse_colour("#ff8000", colour));
    EXPECT_FLOAT_EQ(colour.g, 128.0f / 255.0f);
    EXPECT_FALSE(hw::parse_colour("#ff80", colour));
    EXPECT_FALSE(hw::parse_colour("#ff80zz", colour));
}
