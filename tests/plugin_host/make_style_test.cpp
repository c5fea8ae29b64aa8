#include "hatchway/plugin_host/make_style.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/plugin_host/plugin_tests.hpp"

using namespace hw;
using namespace hw::test;
using testing::HasSubstr;

namespace {

const StyleSource kSource{"hall.level.json", "/styles/assumed"};

std::unique_ptr<Style> made(const std::string& plugin, const ParamSettings& params = {})
{
    return make_style(require_plugin(test_registry(), plugin, PluginKind::style, kSource), params, kSource);
}

ParamSettings one(const std::string& name, ParamValue value)
{
    return {{name, {std::move(value), "/styles/assumed/" + name}}};
}

/// Checks what the manual demands of every parameter.
struct ParamCritic final : ParamVisitor {
    void real(const ParamInfo& info, float& value, float min, float max) override
    {
        check(info);
        EXPECT_LT(min, max) << info.name;
        EXPECT_TRUE(value >= min && value <= max) << info.name << ": the default is out of range";
    }
    void whole(const ParamInfo& info, int& value, int min, int max) override
    {
        check(info);
        EXPECT_TRUE(value >= min && value <= max) << info.name;
    }
    void flag(const ParamInfo& info, bool&) override { check(info); }
    void colour(const ParamInfo& info, glm::vec3&) override { check(info); }
    void choice_of(const ParamInfo& info, int& index, std::span<const std::string_view> names) override
    {
        check(info);
        EXPECT_TRUE(index >= 0 && index < static_cast<int>(names.size())) << info.name;
    }
    void map(const ParamInfo& info, MapName&, MapKind) override { check(info); }
    void image(const ParamInfo& info, ImageFile&) override { check(info); }

    void check(const ParamInfo& info)
    {
        EXPECT_TRUE(is_plugin_name(info.name)) << info.name;
        EXPECT_TRUE(info.help.size() > 10 && info.help.back() == '.') << info.name << ": " << info.help;
        EXPECT_TRUE(seen.insert(std::string(info.name)).second) << info.name << " is visited twice";
    }
    std::set<std::string> seen;
};

}  // namespace

TEST(make_style, a_missing_plugin_lists_those_there_are)
{
    const std::string said = refusal([] { made("pencil"); });
    EXPECT_THAT(said,
                HasSubstr("hall.level.json: /styles/assumed: there is no style plugin \"pencil\"; expected one of: "));
    for (const char* name : {"hybrid", "pen_and_ink", "photoreal"}) EXPECT_THAT(said, HasSubstr(name));
}

TEST(make_style, a_refused_plugin_says_why)
{
    EXPECT_THAT(refusal([] { made("old_version"); }), HasSubstr("cannot be used: it was written for version 1"));
}

TEST(make_style, an_unknown_parameter_lists_those_there_are)
{
    const std::string message = refusal([] { made("photoreal", one("line_width_px", 2.0)); });
    EXPECT_THAT(message, HasSubstr("/styles/assumed/line_width_px: there is no parameter \"line_width_px\""));
    EXPECT_THAT(message, HasSubstr("brightness, saturation, tint, shadows"));
}

TEST(make_style, a_value_out_of_range_says_the_range)
{
    EXPECT_THAT(refusal([] { made("pen_and_ink", one("crease_deg", 400.0)); }),
                HasSubstr("crease_deg is 400; expected a number from 1 to 180"));
}

TEST(make_style, a_plugin_that_throws_when_made_is_an_error_with_its_reason)
{
    EXPECT_THAT(refusal([] { made("throws_in_make"); }),
                HasSubstr("the plugin \"throws_in_make\" failed in making an instance: no licence for this pen"));
}

TEST(make_style, a_plugin_that_throws_while_visited_is_an_error_with_its_reason)
{
    EXPECT_THAT(refusal([] { made("throws_where_told", one("where", std::string("visit_params"))); }),
                HasSubstr("told to fail"));
}

TEST(make_style, every_parameter_of_every_plugin_has_a_good_name_help_range_and_default)
{
    const PluginRegistry registry({.has_installed = false, .compiled_in = static_plugins()});
    for (const Plugin& plugin : registry.plugins()) {
        SCOPED_TRACE(plugin.name);
        ParamCritic critic;
        visit_defaults(plugin, critic);
        EXPECT_FALSE(critic.seen.empty());
    }
    EXPECT_GE(registry.plugins().size(), 4u);
}

TEST(make_style, a_level_s_unused_style_is_checked_too)
{
    Level level;
    level.file = "hall.level.json";
    level.styles["unused"] = {"pen_and_ink", one("spacing_px", std::string("wide")), "/styles/unused"};
    EXPECT_THAT(refusal([&] { check_styles(test_registry(), level); }), HasSubstr("spacing_px is \"wide\""));
    level.styles["unused"] = {"crayon", {}, "/styles/unused"};
    EXPECT_THAT(refusal([&] { check_styles(test_registry(), level); }), HasSubstr("/styles/unused/plugin"));
}

TEST(make_style, ink_needs_edges_and_photoreal_needs_none)
{
    EXPECT_FALSE(made("photoreal")->needs().edges.has_value());
    EXPECT_FALSE(made("photoreal")->needs().streams.hatch_uv);
    ASSERT_TRUE(made("pen_and_ink")->needs().edges.has_value());
    const auto wide = made("pen_and_ink", one("crease_deg", 60.0))->needs();
    EXPECT_NEAR(wide.edges->crease_rad, 1.0471975f, 1e-6f);
}

TEST(make_style, every_style_that_a_level_names_is_looked_up_and_its_place_told)
{
    Level level;
    level.file = "hall.level.json";
    level.certainty_styles = {{0.0, "photoreal"}, {0.5, "gone"}};
    EXPECT_THAT(refusal([&] { check_styles(test_registry(), level); }),
                HasSubstr("hall.level.json: /certainty_styles/1/style: there is no style \"gone\"; expected one of: "));
    AssignRule rule;
    rule.style = "photoreal";
    rule.over = "gone";
    rule.pointer = "/assign/0";
    level.assign = {rule};
    EXPECT_THAT(refusal([&] { check_styles(test_registry(), level); }),
                HasSubstr(": /assign/0/over: there is no style"));
    level.assign[0].style = "gone too";
    EXPECT_THAT(refusal([&] { check_styles(test_registry(), level); }),
                HasSubstr(": /assign/0/style: there is no style"));
    level.assign[0].pointer = "--style 1";
    EXPECT_THAT(refusal([&] { check_styles(test_registry(), level); }), HasSubstr(": --style 1: there is no style"));
}

TEST(make_style, maps_that_a_style_states_are_found_although_its_tone_leaves_them_unused)
{
    Level level;
    ParamSettings params = one("hatch", std::string("zzz"));
    params["tone"] = {std::string("shaded"), "/styles/assumed/tone"};
    level.styles["assumed"] = {"pen_and_ink", params, "/styles/assumed"};
    const auto maps = maps_of_styles(test_registry(), level);
    ASSERT_EQ(maps.size(), 1u) << "what the level does not state is the plugin's own matter";
    EXPECT_EQ(maps[0].kind, MapKind::hatch);
    EXPECT_EQ(maps[0].name, "zzz");
    EXPECT_EQ(maps[0].pointer, "/styles/assumed/hatch");
}
