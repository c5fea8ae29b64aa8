#include <gtest/gtest.h>

#include <fstream>

#include "hatchway/core/error.hpp"
#include "hatchway/param/param_reader.hpp"
#include "tests/temporary_folder.hpp"

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

TEST(param_reader, a_whole_number_has_no_fraction_and_a_range)
{
    int count = 3;
    const auto read = [&](hw::ParamValue value) {
        const auto settings = one_setting("pens", std::move(value));
        hw::ParamReader reader(settings, "a.json");
        reader.whole({"pens", ""}, count, 1, 8);
    };
    read(8.0);
    EXPECT_EQ(count, 8);
    for (const hw::ParamValue& wrong : {hw::ParamValue(2.5), hw::ParamValue(9.0), hw::ParamValue(true)})
        EXPECT_NE(refusal([&] { read(wrong); }).find("expected a whole number from 1 to 8"), std::string::npos);
    EXPECT_EQ(count, 8);
}

TEST(param_reader, a_flag_is_true_or_false)
{
    bool flag = false;
    const auto read = [&](hw::ParamValue value) {
        const auto settings = one_setting("shadows", std::move(value));
        hw::ParamReader reader(settings, "a.json");
        reader.flag({"shadows", ""}, flag);
    };
    read(true);
    EXPECT_TRUE(flag);
    for (const hw::ParamValue& wrong : {hw::ParamValue(1.0), hw::ParamValue(std::string("true"))})
        EXPECT_NE(refusal([&] { read(wrong); }).find("expected true or false"), std::string::npos);
}

TEST(param_reader, colours_and_maps_are_texts)
{
    glm::vec3 colour(0.0f);
    hw::MapName map{"fine"};
    const auto settings = hw::ParamSettings{{"ink_colour", {std::string("#ff8000"), "/styles/a/ink_colour"}},
                                            {"hatch", {std::string("../maps/mine"), "/styles/a/hatch"}}};
    hw::ParamReader reader(settings, "a.json");
    reader.colour({"ink_colour", ""}, colour);
    reader.map({"hatch", ""}, map, hw::MapKind::hatch);
    EXPECT_FLOAT_EQ(colour.g, 128.0f / 255.0f);
    EXPECT_EQ(map.value, "../maps/mine");
    const auto wrong = one_setting("ink_colour", std::string("orange"));
    hw::ParamReader refusing(wrong, "a.json");
    EXPECT_NE(refusal([&] {
                  refusing.colour({"ink_colour", ""}, colour);
              }).find("ink_colour is \"orange\"; expected a colour such as \"#1a2b3c\""),
              std::string::npos);
    const auto number = one_setting("hatch", 3.0);
    hw::ParamReader other(number, "a.json");
    EXPECT_NE(refusal([&] {
                  other.map({"hatch", ""}, map, hw::MapKind::hatch);
              }).find("hatch is 3"),
              std::string::npos);
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

TEST(param_reader, an_angle_is_stated_in_degrees_and_held_in_radians)
{
    float crease_rad = 0.7f;
    const auto settings = one_setting("crease_deg", 90.0);
    hw::ParamReader reader(settings, "a.json");
    reader.angle({"crease_deg", ""}, crease_rad, 1.0f, 180.0f);
    EXPECT_FLOAT_EQ(crease_rad, 1.5707964f);
    const auto too_large = one_setting("crease_deg", 181.0);
    hw::ParamReader refusing(too_large, "a.json");
    EXPECT_NE(refusal([&] { refusing.angle({"crease_deg", ""}, crease_rad, 1.0f, 180.0f); }), "");
}

TEST(param_reader, an_angle_that_nobody_states_keeps_its_bits)
{
    float crease_rad = 0.69813168f;
    const float before = crease_rad;
    const hw::ParamSettings none;
    hw::ParamReader reader(none, "a.json");
    reader.angle({"crease_deg", ""}, crease_rad, 1.0f, 180.0f);
    EXPECT_EQ(crease_rad, before);
}

TEST(param_reader, a_choice_is_an_enum_by_the_names_of_its_values)
{
    enum class Tone { none, plain, shaded };
    constexpr std::string_view kNames[] = {"none", "plain", "shaded"};
    Tone tone = Tone::none;
    const auto settings = one_setting("tone", std::string("shaded"));
    hw::ParamReader reader(settings, "a.json");
    hw::ParamVisitor& visitor = reader;
    visitor.choice({"tone", ""}, tone, kNames);
    EXPECT_EQ(tone, Tone::shaded);
    const auto wrong = one_setting("tone", std::string("dark"));
    hw::ParamReader refusing(wrong, "a.json");
    hw::ParamVisitor& other = refusing;
    EXPECT_NE(refusal([&] {
                  other.choice({"tone", ""}, tone, kNames);
              }).find("one of: none, plain, shaded"),
              std::string::npos);
    EXPECT_EQ(tone, Tone::shaded);
}

TEST(param_reader, an_image_of_a_level_lies_inside_of_its_project_and_is_there)
{
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.path() / "project/levels");
    std::ofstream(folder.path() / "project/grain.png") << "png";
    std::ofstream(folder.path() / "outside.png") << "png";
    const std::string level = (folder.path() / "project/levels/a.json").string();
    const auto read = [&](const std::string& stated) {
        hw::ImageFile image{"own.png"};
        const auto settings = one_setting("grain", stated);
        hw::ParamReader reader(settings, level, folder.path() / "project");
        reader.image({"grain", ""}, image);
        return image.value;
    };
    EXPECT_EQ(std::filesystem::weakly_canonical(read("../grain.png")),
              std::filesystem::weakly_canonical(folder.path() / "project/grain.png"));
    EXPECT_TRUE(std::filesystem::path(read("../grain.png")).is_absolute());
    EXPECT_EQ(read(""), "") << "none";
    for (const std::string& bad : {std::string("../../outside.png"), std::string("none.png"), std::string(".."),
                                   (folder.path() / "outside.png").string()})
        EXPECT_NE(refusal([&] { read(bad); }).find("/styles/assumed/grain"), std::string::npos) << bad;
    std::filesystem::create_symlink(folder.path() / "outside.png", folder.path() / "project/levels/link.png");
    EXPECT_NE(refusal([&] { read("link.png"); }), "") << "a link that leads out";
}

TEST(param_reader, an_image_that_no_level_names_is_the_style_s_own)
{
    hw::ImageFile image{"own.png"};
    const hw::ParamSettings none;
    hw::ParamReader reader(none, "a.json", "/project");
    reader.image({"grain", ""}, image);
    EXPECT_EQ(image.value, "own.png");
}
