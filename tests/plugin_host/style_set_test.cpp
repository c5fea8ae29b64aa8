#include "hatchway/plugin_host/style_set.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hatchway/drawing/frame_items.hpp"
#include "tests/plugin_host/plugin_tests.hpp"

using namespace hw;
using namespace hw::test;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

Level level_with(const std::string& name, const std::string& plugin, ParamSettings params = {})
{
    Level level;
    level.file = "hall.level.json";
    level.styles[name] = {plugin, std::move(params), "/styles/" + name};
    return level;
}

ParamSettings failing_in(const std::string& place)
{
    return {{"where", {place, "/styles/bad/where"}}};
}

struct StyleSetTest : testing::Test {
    FakeProgramCache programs;
    StyleSet set{test_registry(), [this](const std::filesystem::path&) -> ProgramCache& { return programs; }};
    FakePass pass;
    std::vector<DrawItem> items{2};
};

using style_set = StyleSetTest;

}  // namespace

TEST_F(style_set, a_style_is_prepared_on_first_use_and_only_once)
{
    set.set_level(level_with("assumed", "pen_and_ink"));
    EXPECT_THAT(programs.asked, ElementsAre("plain.frag|"));
    EXPECT_EQ(set.use("assumed", ""), 0);
    EXPECT_EQ(set.use("photoreal", ""), 1);
    EXPECT_EQ(set.use("assumed", ""), 0);
    EXPECT_EQ(programs.asked.size(), 3u);
    EXPECT_EQ(set.styles()[1].name, "photoreal");
}

TEST_F(style_set, a_level_s_style_hides_the_plugin_of_its_name)
{
    set.set_level(level_with("photoreal", "pen_and_ink"));
    EXPECT_TRUE(set.styles().empty());
    set.use("photoreal", "");
    EXPECT_TRUE(set.styles()[0].style->needs().edges.has_value());
    EXPECT_EQ(std::ranges::count(set.names(), "photoreal"), 1);
}

TEST_F(style_set, an_unknown_style_lists_the_level_s_styles_and_the_plugins)
{
    set.set_level(level_with("assumed", "pen_and_ink"));
    const std::string message = refusal([&] { set.use("asumed", "/assign/3/style"); });
    EXPECT_THAT(message,
                HasSubstr("hall.level.json: /assign/3/style: there is no style \"asumed\"; expected one of: assumed"));
    EXPECT_THAT(message, HasSubstr("photoreal"));
}

TEST_F(style_set, a_plugin_that_fails_to_prepare_is_bad_input)
{
    for (const std::string place : {"prepare", "needs", "a_number"}) {
        set.set_level(level_with("bad", "throws_where_told", failing_in(place)));
        EXPECT_THAT(refusal([&] { set.use("bad", "/assign/0/style"); }), HasSubstr("throws_where_told\" failed in"))
            << place;
    }
    EXPECT_TRUE(set.styles().empty());
}

TEST_F(style_set, a_style_that_throws_while_drawing_is_drawn_plain_from_then_on)
{
    set.set_level(level_with("bad", "throws_where_told", failing_in("surfaces")));
    Style& style = *set.styles()[set.use("bad", "")].style;
    style.surfaces(pass, items);
    style.surfaces(pass, items);
    style.lines(pass, items);
    EXPECT_EQ(pass.drawn_surfaces, 4u);
    ASSERT_EQ(set.failures().size(), 1u);
    EXPECT_THAT(
        set.failures()[0],
        HasSubstr(
            "the style \"bad\" is drawn plain: the plugin \"throws_where_told\" failed in surfaces: told to fail"));
}

TEST_F(style_set, a_failure_names_the_object_at_which_the_style_throws)
{
    set.set_object_namer([](std::uint32_t object) { return "Hall/Column_" + std::to_string(object); });
    set.set_level(level_with("bad", "throws_where_told",
                             {{"where", {"surfaces", "/styles/bad/where"}}, {"object", {2.0, "/styles/bad/object"}}}));
    Style& style = *set.styles()[set.use("bad", "")].style;
    Scene scene;
    scene.nodes.resize(1);
    scene.meshes.resize(1);
    scene.materials.resize(1);
    FrameItems made;
    std::vector<DrawItem> named;
    for (ObjectId id = 0; id < 4; ++id) {
        scene.objects.push_back({.node = 0, .mesh = 0, .material = 0});
        named.push_back(made.make(scene, id, {}, false, id));
    }
    style.surfaces(pass, named);
    EXPECT_EQ(pass.drawn_surfaces, 4u) << "what was drawn to find it out reached nothing";
    ASSERT_EQ(set.failures().size(), 1u);
    EXPECT_THAT(set.failures()[0], HasSubstr("the style \"bad\" is drawn plain at the object \"Hall/Column_2\": "));
}

TEST_F(style_set, an_image_pass_that_throws_tells_it_once_and_makes_nothing)
{
    struct Throwing final : ImagePass {
        Needs needs() const override { return {}; }
        void prepare(ProgramCache&) override {}
        Images make(Pass&, Items) override { throw std::runtime_error("no ink"); }
    };
    std::vector<std::string> told;
    const ObjectNamer nobody;
    GuardedImagePass image(Guarded{"wash", nobody}, std::make_unique<Throwing>(),
                           [&](const std::string& text) { told.push_back(text); });
    EXPECT_EQ(image.make(pass, items).size(), 0u);
    EXPECT_EQ(image.make(pass, items).size(), 0u);
    EXPECT_THAT(told, ElementsAre(HasSubstr("the image pass \"wash\" makes no image")));
}

TEST_F(style_set, a_style_that_throws_in_its_lines_keeps_its_objects_in_the_picture)
{
    set.set_level(level_with("bad", "throws_where_told", failing_in("lines")));
    Style& style = *set.styles()[set.use("bad", "")].style;
    style.surfaces(pass, items);
    style.lines(pass, items);
    style.surfaces(pass, items);
    EXPECT_EQ(pass.drawn_surfaces, 4u);
    EXPECT_EQ(set.failures().size(), 1u);
}

TEST_F(style_set, a_changed_level_remakes_only_what_changed_and_pointers_stay)
{
    set.set_level(level_with("assumed", "pen_and_ink"));
    set.use("assumed", "");
    set.use("photoreal", "");
    Style* const before = set.styles()[0].style;
    const std::size_t asked = programs.asked.size();
    set.set_level(level_with("assumed", "pen_and_ink"));
    EXPECT_EQ(programs.asked.size(), asked);
    set.set_level(level_with("assumed", "pen_and_ink", {{"crease_deg", {60.0, ""}}}));
    EXPECT_EQ(programs.asked.size(), asked + 1);
    EXPECT_EQ(set.styles()[0].style, before);
    EXPECT_NEAR(before->needs().edges->crease_rad, 1.0471975f, 1e-6f);
}

TEST_F(style_set, a_wrong_level_leaves_everything_as_it_was)
{
    set.set_level(level_with("assumed", "pen_and_ink", {{"crease_deg", {60.0, ""}}}));
    set.use("assumed", "");
    EXPECT_NE(refusal([&] { set.set_level(level_with("assumed", "pen_and_ink", {{"crease_deg", {999.0, ""}}})); }), "");
    programs.fails_for = "photoreal.frag";
    EXPECT_NE(refusal([&] { set.set_level(level_with("assumed", "photoreal")); }), "");
    EXPECT_NEAR(set.styles()[0].style->needs().edges->crease_rad, 1.0471975f, 1e-6f);
    EXPECT_EQ(set.names().front(), "assumed");
}

TEST_F(style_set, a_shader_that_no_longer_compiles_keeps_the_last_good_instance)
{
    set.use("photoreal", "");
    programs.fails_for = "photoreal.frag";
    const auto messages = set.prepare_again();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_THAT(messages[0], HasSubstr("the style \"photoreal\" stays as it was: photoreal.frag: does not compile"));
    set.styles()[0].style->surfaces(pass, items);
    EXPECT_EQ(pass.drawn_surfaces, 2u);
    programs.fails_for.clear();
    EXPECT_TRUE(set.prepare_again().empty());
}

TEST_F(style_set, an_image_pass_is_made_with_the_parameters_of_its_key)
{
    set_log_level(LogLevel::off);
    const ImagePassSource source = set.image_passes();
    const auto edge_map = source({"edge_map", {{"operator", std::string("c1")}}});
    ASSERT_NE(edge_map, nullptr);
    EXPECT_THAT(programs.asked, testing::Contains("c1.frag|"));
    const Needs needs = edge_map->needs();
    const ImageKey& read = needs.images.at(0);
    EXPECT_EQ(read.pass, "normal_depth");
    EXPECT_EQ(read.params.at("normal"), ParamValue(std::string("face")));
    EXPECT_TRUE(edge_map->make(pass, {})[0].is_valid());
    EXPECT_EQ(source({"edge_map", {{"operator", std::string("sobel")}}}), nullptr);
    EXPECT_EQ(source({"no_such_pass", {}}), nullptr);
}

TEST_F(style_set, hybrid_lines_fade_over_the_height_of_each_object)
{
    Style& style = *set.styles()[set.use("hybrid", "")].style;
    items[0] = FrameItems().make({.bounds_world = {{0, 1, 0}, {1, 5, 1}}}, {.presence = {.height = Ramp{0.0f, 9.0f}}});
    style.lines(pass, items);
    ASSERT_EQ(pass.line_items.size(), 2u);
    EXPECT_EQ(FrameItems::presence(pass.line_items[0]).height, (Ramp{0.0f, 9.0f})) << "the level's, as it came";
    ASSERT_TRUE(pass.line_looks[0].share.height);
    EXPECT_FLOAT_EQ(pass.line_looks[0].share.height->from, 2.0f);
    EXPECT_FLOAT_EQ(pass.line_looks[0].share.height->to, 3.0f);
}
