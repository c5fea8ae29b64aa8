// What a newcomer stumbled over in an hour with the program: each was a fault of the program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "tests/program/run_program.hpp"

namespace {
namespace fs = std::filesystem;
using hw::test::bytes_of;
using hw::test::kContent;
using hw::test::ProgramResult;
using hw::test::run_program;
using hw::test::TemporaryFolder;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const fs::path kMisbehaving = fs::path(HATCHWAY_BUILD_DIR) / "tests/plugin_host/misbehaving";

std::size_t count_of(const std::string& text, const std::string& part)
{
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

/// A folder with the paper's prism and a room for plugins.
class newcomer : public testing::Test {
 protected:
    newcomer()
    {
        fs::copy_file(kContent / "models/prism.glb", folder_ / "prism.glb");
        fs::create_directories(folder_ / "plugins");
    }
    std::string level(const std::string& keys, const std::string& name = "a.level.json") const
    {
        return folder_.write(name, R"({"format": "hatchway-level/1", "scene": "prism.glb", )" + keys + "}");
    }
    void install(const std::string& plugin) const
    {
        fs::copy_file(kMisbehaving / (plugin + ".so"), folder_ / ("plugins/" + plugin + ".so"));
    }
    /// A copy of the prism with other extras on its nodes.
    std::string model_saying(const json& extras) const
    {
        std::string bytes = bytes_of(folder_ / "prism.glb");
        const auto word = [&](std::size_t at) {
            std::uint32_t value = 0;
            std::memcpy(&value, bytes.data() + at, 4);
            return value;
        };
        const std::uint32_t length = word(12);
        json document = json::parse(bytes.substr(20, length));
        for (json& node : document["nodes"]) node["extras"] = extras;
        std::string text = document.dump();
        while (text.size() % 4 != 0) text += ' ';
        std::string made = bytes.substr(0, 20) + text + bytes.substr(20 + length);
        const auto put = [&](std::size_t at, std::size_t size) {
            const auto value = static_cast<std::uint32_t>(size);
            std::memcpy(made.data() + at, &value, 4);
        };
        put(8, made.size());
        put(12, text.size());
        return folder_.write("said.glb", made);
    }
    ProgramResult render(const std::string& file, std::vector<std::string> more = {}) const
    {
        std::vector<std::string> words{"render", file, "--out", folder_ / "a.png", "--size", "160x120"};
        words.insert(words.end(), more.begin(), more.end());
        return run_program(words);
    }

    TemporaryFolder folder_;
};

}  // namespace

TEST_F(newcomer, a_bare_model_that_names_an_unknown_style_is_drawn_as_if_it_named_none)
{
    const ProgramResult plain = render(folder_ / "prism.glb");
    ASSERT_EQ(plain.exit_code, 0);
    const std::string picture = bytes_of(folder_ / "a.png");
    const std::string said = model_saying({{"hatchway", {{"style", "found"}}}});
    const ProgramResult warned = render(said);
    EXPECT_EQ(warned.exit_code, 0) << warned.err;
    EXPECT_EQ(count_of(warned.err, "\"found\""), 1u) << warned.err;
    EXPECT_EQ(bytes_of(folder_ / "a.png"), picture);
    const ProgramResult inked = render(said, {"--style", "*=pen_and_ink"});
    EXPECT_EQ(inked.exit_code, 0) << inked.err;
    EXPECT_NE(bytes_of(folder_ / "a.png"), picture);
    for (const char* command : {"check", "info", "compile", "bake"})
        EXPECT_EQ(run_program({command, said}).exit_code, 0) << command;
    EXPECT_EQ(run_program({"lines", said, "--out", folder_ / "a.svg"}).exit_code, 0);
    EXPECT_EQ(run_program({"lines", said, "--style", "*=pen_and_ink", "--out", folder_ / "a.svg"}).exit_code, 0);
    // A plugin is a style that every program knows.
    EXPECT_EQ(render(model_saying({{"hatchway", {{"style", "pen_and_ink"}}}})).err, "");
    // A level defines what its model names.
    level(R"("exposure_ev": 12)");
    std::string text = bytes_of(folder_ / "a.level.json");
    model_saying({{"hatchway", {{"style", "found"}}}});
    text.replace(text.find("prism.glb"), 9, "said.glb");
    EXPECT_EQ(render(folder_.write("b.level.json", text)).exit_code, 2);
}

TEST_F(newcomer, check_names_what_a_model_says_in_vain)
{
    const std::string file = model_saying({{"certainty", "quite"}});
    const ProgramResult checked = run_program({"check", file, "--json", folder_ / "c.json"});
    EXPECT_EQ(checked.exit_code, 0);
    EXPECT_THAT(checked.err, HasSubstr("/extras/certainty: the text \"quite\" is no certainty"));
    EXPECT_THAT(checked.out, HasSubstr("1 warning"));
    EXPECT_EQ(json::parse(bytes_of(folder_ / "c.json"))["warnings"].size(), 1u);
}

TEST_F(newcomer, a_style_that_throws_ends_with_1_and_both_names)
{
    install("throws_where_told");
    const std::string file = level(R"("styles": {"mine": {"plugin": "throws_where_told", "where": "surfaces"}},
                                      "assign": [{"nodes": "*", "style": "mine"}])");
    const ProgramResult result = render(file, {"--plugin-dir", folder_ / "plugins"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, AllOf(HasSubstr("style \"mine\""), HasSubstr("object \"Prism"), HasSubstr("told to fail")));
    EXPECT_TRUE(fs::exists(folder_ / "a.png")) << "drawn plain";
    EXPECT_EQ(run_program({"check", file, "--plugin-dir", folder_ / "plugins"}).exit_code, 1);
    const std::string lined = level(R"("styles": {"mine": {"plugin": "throws_where_told", "where": "lines"}},
                                       "assign": [{"nodes": "*", "style": "mine"}])");
    const ProgramResult lines =
        run_program({"lines", lined, "--out", folder_ / "a.svg", "--plugin-dir", folder_ / "plugins"});
    EXPECT_EQ(lines.exit_code, 1);
    EXPECT_THAT(lines.err, AllOf(HasSubstr("style \"mine\""), HasSubstr("object \"Prism")));
    EXPECT_FALSE(fs::exists(folder_ / "a.svg"));
}

TEST_F(newcomer, statistics_count_the_lines_that_are_drawn)
{
    for (const char* way : {"quads", "native"}) {
        const ProgramResult result = render(folder_ / "prism.glb", {"--style", "*=pen_and_ink", "--lines", way,
                                                                    "--stats", "--json", folder_ / "s.json"});
        EXPECT_THAT(result.out, Not(HasSubstr(" 0 lines"))) << way;
        // Sixteen creases and two upright contours, or more where a crease is one, too.
        EXPECT_GE(json::parse(bytes_of(folder_ / "s.json"))["frames"][0]["lines"], 18) << way;
        EXPECT_LE(json::parse(bytes_of(folder_ / "s.json"))["frames"][0]["lines"], 42) << way;
    }
}

TEST_F(newcomer, what_is_not_visible_is_in_no_picture_drawing_or_number)
{
    const std::string shown = level(R"("assign": [{"nodes": "*", "style": "pen_and_ink"}])");
    const std::string hidden = level(
        R"("assign": [{"nodes": "*", "style": "pen_and_ink"}, {"nodes": "*", "visible": false}])", "b.level.json");
    const std::vector<std::string> eye{"--eye", "3,1,7", "--target", "0,0,0"};
    ASSERT_EQ(render(hidden, eye).exit_code, 0);
    const std::string picture = bytes_of(folder_ / "a.png");
    ASSERT_EQ(render(shown, eye).exit_code, 0);
    EXPECT_NE(bytes_of(folder_ / "a.png"), picture);
    const auto lines = [&](const std::string& file) {
        const ProgramResult result = run_program({"lines", file, "--eye", "3,1,7", "--target", "0,0,0", "--out",
                                                  folder_ / "a.svg", "--json", folder_ / "l.json"});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return json::parse(bytes_of(folder_ / "l.json"))["lines"].size();
    };
    EXPECT_GT(lines(shown), 0u);
    EXPECT_EQ(lines(hidden), 0u);
    const ProgramResult silhouettes = run_program({"silhouettes", hidden, "--eye", "3,1,7"});
    EXPECT_THAT(silhouettes.out, HasSubstr("0 faces"));
    EXPECT_THAT(run_program({"info", hidden}).out, HasSubstr("1 objects (1 hidden)"));
    EXPECT_THAT(run_program({"check", hidden}).out, HasSubstr("(1 hidden)"));
    EXPECT_EQ(run_program({"compile", hidden}).exit_code, 0) << "of an empty scene";
    EXPECT_EQ(run_program({"bake", hidden}).exit_code, 2) << "there is nothing to bake";
    EXPECT_EQ(render(hidden).exit_code, 0) << "without a camera, too";
}

TEST_F(newcomer, check_and_info_use_the_compiled_level_and_say_so)
{
    const std::string file = level(R"("exposure_ev": 12)");
    const std::string cache = folder_ / "cache";
    for (const char* command : {"check", "info"}) {
        const auto run = [&] { return run_program({command, file, "--cache", cache, "--json", folder_ / "r.json"}); };
        fs::remove_all(cache);
        EXPECT_THAT(run().out, Not(HasSubstr("compiled level"))) << command;
        EXPECT_FALSE(json::parse(bytes_of(folder_ / "r.json"))["is_compiled_level_used"]) << command;
        ASSERT_EQ(run_program({"compile", file, "--cache", cache}).exit_code, 0);
        EXPECT_THAT(run().out, HasSubstr("from the compiled level")) << command;
        EXPECT_TRUE(json::parse(bytes_of(folder_ / "r.json"))["is_compiled_level_used"]) << command;
    }
}

TEST_F(newcomer, a_wrong_name_of_structure_is_told_by_every_command)
{
    const std::string file = level(R"("structure": ["Prism*", "Wall*"])");
    for (const std::vector<std::string>& words : {std::vector<std::string>{"check", file},
                                                  {"info", file},
                                                  {"compile", file},
                                                  {"bake", file},
                                                  {"silhouettes", file, "--eye", "3,1,7"},
                                                  {"lines", file, "--out", folder_ / "a.svg"},
                                                  {"render", file, "--out", folder_ / "a.png"}}) {
        const ProgramResult result = run_program(words);
        EXPECT_EQ(result.exit_code, 2) << words[0];
        EXPECT_THAT(result.err, HasSubstr("a.level.json: /structure/1: \"Wall*\" names no node")) << words[0];
    }
}

TEST_F(newcomer, a_map_that_there_is_not_is_told_with_those_there_are)
{
    const ProgramResult result = run_program({"check", level(R"("assign": [{"maps": {"ink": "stones"}}])")});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err,
                AllOf(HasSubstr("/assign/0/maps/ink: there is no map \"stones\""), HasSubstr("stone_courses")));
}

TEST_F(newcomer, a_rule_that_says_nothing_is_doubted)
{
    EXPECT_THAT(run_program({"check", level(R"("assign": [{"nodes": "*"}])")}).err,
                HasSubstr("/assign/0: the rule says nothing"));
}

TEST_F(newcomer, pictures_of_a_path_are_told_with_their_folder)
{
    const ProgramResult result = run_program({"render", folder_ / "prism.glb", "--path", "turntable", "--frames", "2",
                                              "--size", "64x48", "--out", folder_ / "pictures"});
    EXPECT_EQ(result.out, (folder_ / "pictures") + ": 2 pictures\n");
}

TEST_F(newcomer, info_lists_nodes_with_what_the_rules_say_and_which)
{
    const std::string file = level(R"("assign": [{"nodes": "*", "style": "pen_and_ink", "certainty": 0.4},
        {"nodes": "*", "style": "photoreal", "over": "pen_and_ink"}, {"nodes": "*", "visible": false}])");
    ASSERT_EQ(run_program({"info", file, "--nodes", "--json", folder_ / "n.json"}).exit_code, 0);
    const json nodes = json::parse(bytes_of(folder_ / "n.json"))["nodes"];
    ASSERT_EQ(nodes.size(), 1u);
    EXPECT_THAT(nodes[0]["path"].get<std::string>(), HasSubstr("Prism"));
    EXPECT_EQ(nodes[0]["style"], "photoreal");
    EXPECT_EQ(nodes[0]["style_rule"], "/assign/1/style");
    EXPECT_EQ(nodes[0]["over"], "pen_and_ink");
    EXPECT_EQ(nodes[0]["over_rule"], "/assign/1/over");
    EXPECT_EQ(nodes[0]["certainty"], 0.4);
    EXPECT_EQ(nodes[0]["certainty_rule"], "/assign/0/certainty");
    EXPECT_EQ(nodes[0]["is_visible"], false);
    EXPECT_EQ(nodes[0]["visible_rule"], "/assign/2/visible");
    // Where nobody says anything, no rule is named.
    ASSERT_EQ(run_program({"info", folder_ / "prism.glb", "--nodes", "--json", folder_ / "n.json"}).exit_code, 0);
    EXPECT_EQ(json::parse(bytes_of(folder_ / "n.json"))["nodes"][0]["style_rule"], "");
}

TEST_F(newcomer, info_says_photoreal_where_a_bare_model_names_a_style_that_there_is_not)
{
    const std::string file = model_saying({{"hatchway", {{"style", "mine"}}}});
    const ProgramResult result = run_program({"info", file, "--nodes", "--json", folder_ / "n.json"});
    EXPECT_THAT(result.err, HasSubstr("the style \"mine\", which there is not"));
    const json node = json::parse(bytes_of(folder_ / "n.json"))["nodes"][0];
    EXPECT_EQ(node["style"], "photoreal");
    EXPECT_EQ(node["style_rule"], "");
}

TEST_F(newcomer, check_finds_the_silent_mistakes_of_a_style_once_each)
{
    install("silent_mistakes");
    fs::create_directories(folder_ / "plugins/silent_mistakes");
    // "float a = 1" is right on the desktop, and wrong on OpenGL ES.
    folder_.write("plugins/silent_mistakes/silent_mistakes.frag",
                  "#include \"surface.glsl\"\nuniform vec3 tint;\nuniform sampler2D noise;\nvoid main()\n{\n"
                  "    float one = 1;\n    hw_output(tint * one + texture(noise, vec2(0.5)).rgb, 1.0);\n}\n");
    const ProgramResult result = run_program(
        {"check", folder_ / "prism.glb", "--style", "*=silent_mistakes", "--plugin-dir", folder_ / "plugins"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    for (const char* told : {"\"lineWidth\" is not named", "\"upside_down\" has the range 4 to 1",
                             "\"outside\" has the default 7", "\"mute\" has no sentence", "sets \"grian\"",
                             "reads the image \"normal_depth\"", "OpenGL ES refuses a shader"})
        EXPECT_EQ(count_of(result.err, told), 1u) << told << '\n' << result.err;
    EXPECT_THAT(result.err, Not(HasSubstr("\"tint\"")));
    EXPECT_THAT(result.out, HasSubstr("7 warnings"));
}

TEST_F(newcomer, the_styles_that_come_with_it_have_no_silent_mistakes)
{
    for (const char* style : {"photoreal", "pen_and_ink", "hybrid", "technical", "id_outline", "cartoon", "halftone"}) {
        const ProgramResult result =
            run_program({"check", folder_ / "prism.glb", "--style", "*=" + std::string(style)});
        EXPECT_THAT(result.out, HasSubstr("0 warnings")) << style << result.err;
    }
}
