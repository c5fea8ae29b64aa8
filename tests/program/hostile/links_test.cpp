// Links and loops of links that a stranger's level brings: no file of the user is read or written through them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/program/run_program.hpp"

namespace hw::test {
namespace {
namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kLevel = R"({
  "format": "hatchway-level/1", "scene": "prism.glb",
  "assign": [{"nodes": "*", "style": "pen_and_ink", "maps": {"hatch": "./courses"}}]
})";

/// A project with a file of the user, and a stranger's level in a folder of it.
class links : public testing::Test {
 protected:
    links()
    {
        folder_.write("source.cpp", "mine");
        fs::create_directories(folder_ / "strange");
        fs::create_directories(folder_ / "outside");
        fs::copy_file(kContent / "models" / "prism.glb", folder_ / "strange/prism.glb");
    }
    ~links() override { EXPECT_EQ(bytes_of(folder_ / "source.cpp"), "mine"); }

    std::string strange(const std::string& name) const { return folder_ / ("strange/" + name); }
    void link(const std::string& name) const { fs::create_symlink("../source.cpp", strange(name)); }
    bool is_file(const std::string& file) const { return fs::is_regular_file(fs::symlink_status(file)); }
    ProgramResult draw(const std::string& file, const std::string& out) const
    {
        return run_program({"render", file, "--size", "64x48", "--out", out}, 20.0);
    }

    TemporaryFolder folder_;
};

}  // namespace

TEST_F(links, in_place_of_an_output_are_replaced)
{
    const std::string model = strange("prism.glb");
    const std::vector<std::vector<std::string>> commands{
        {"render", model, "--size", "64x48", "--out", strange("a.png")},
        {"check", model, "--json", strange("a.json")},
        {"lines", model, "--style", "*=pen_and_ink", "--size", "64x48", "--out", strange("a.svg")},
        {"lines", model, "--style", "*=pen_and_ink", "--size", "64x48", "--out", strange("a.pdf")},
        {"compile", model, "--out", strange("a.compiled")},
        {"compile", model, "--prt", strange("a.prt")},
        {"bake", model, "--quality", "draft", "--samples", "1"},
        {"bake", model, "--quality", "draft", "--samples", "1", "--out", strange("a.lightmap")},
        {"schema", "--out", strange("a.schema")},
        {"export-edges", model, "--out", strange("a.glb")}};
    for (const std::vector<std::string>& command : commands) {
        const std::string out =
            command[0] == "bake" && command.size() == 6 ? strange("prism.glb.lightmap") : command.back();
        fs::create_symlink("../source.cpp", out);
        const ProgramResult result = run_program(command);
        EXPECT_EQ(result.exit_code, 0) << command[0] << ' ' << result.err;
        EXPECT_TRUE(is_file(out)) << out;
        EXPECT_EQ(bytes_of(folder_ / "source.cpp"), "mine") << out;
    }
}

TEST_F(links, in_a_folder_of_frames_are_replaced_and_a_link_to_a_folder_is_refused)
{
    const auto frames = [&](const std::string& out) {
        return run_program(
            {"render", strange("prism.glb"), "--path", "turntable", "--frames", "2", "--size", "32x32", "--out", out});
    };
    fs::create_directory(strange("out"));
    fs::create_symlink("../../source.cpp", strange("out/frame_0001.png"));
    EXPECT_EQ(frames(strange("out")).exit_code, 0);
    EXPECT_TRUE(is_file(strange("out/frame_0001.png")));
    fs::create_directory_symlink("../outside", strange("to_outside"));
    const ProgramResult refused = frames(strange("to_outside"));
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr("is a link"));
    EXPECT_TRUE(fs::is_empty(folder_ / "outside"));
}

TEST_F(links, that_a_project_brought_are_not_written_through)
{
    const std::string link = strange("to_outside");
    fs::create_directory(folder_ / "outside/deeper");
    fs::create_directory_symlink("../outside", link);
    const std::vector<std::vector<std::string>> commands{
        {"render", strange("prism.glb"), "--size", "32x32", "--out", link + "/p.png"},
        {"render", strange("prism.glb"), "--size", "32x32", "--out", link + "/deeper/p.png"},
        {"render", strange("prism.glb"), "--size", "32x32", "--out", strange("p.png"), "--json", link + "/p.json"},
        {"lines", strange("prism.glb"), "--out", link + "/p.svg"},
        {"info", strange("prism.glb"), "--json", link + "/p.json"}};
    for (const std::vector<std::string>& command : commands) {
        const ProgramResult refused = run_program(command);
        EXPECT_EQ(refused.exit_code, 2) << command[0];
        EXPECT_THAT(refused.err, HasSubstr("goes through a link that the project may have brought"));
    }
    fs::remove(folder_ / "outside/deeper");
    EXPECT_TRUE(fs::is_empty(folder_ / "outside"));
    // A link above the project is the user's own.
    fs::create_directory_symlink(strange("."), folder_ / "mine");
    EXPECT_EQ(
        run_program({"lines", (folder_ / "mine") + "/prism.glb", "--out", (folder_ / "mine") + "/p.svg"}).exit_code, 0);
}

TEST_F(links, at_the_root_of_a_marked_project_are_not_written_through_from_elsewhere)
{
    folder_.write("strange/hatchway.project", "");
    fs::create_directory(strange("models"));
    fs::rename(strange("prism.glb"), strange("models/prism.glb"));
    fs::create_directory_symlink("../outside", strange("pics"));
    const std::string model = strange("models/prism.glb"), pics = strange("pics");
    const std::vector<std::vector<std::string>> commands{{"render", model, "--size", "32x32", "--out", pics + "/p.png"},
                                                         {"check", model, "--json", pics + "/p.json"},
                                                         {"export-edges", model, "--out", pics + "/p.glb"},
                                                         {"map", "hatch", "--width", "64", "--out", pics + "/p"},
                                                         {"new-style", "mine", "--in", pics},
                                                         {"schema", "--out", pics + "/p.json"}};
    for (const std::vector<std::string>& command : commands) {
        const ProgramResult refused = run_program(command);
        EXPECT_EQ(refused.exit_code, 2) << command[0];
        EXPECT_THAT(refused.err, HasSubstr("goes through a link that the project may have brought")) << command[0];
    }
    EXPECT_TRUE(fs::is_empty(folder_ / "outside"));
}

TEST_F(links, in_place_of_a_map_are_replaced)
{
    folder_.write("outside/map.json", "mine");
    fs::create_directory_symlink("../outside", strange("courses"));
    EXPECT_EQ(run_program({"map", "hatch", "--width", "64", "--out", strange("courses")}).exit_code, 0);
    EXPECT_FALSE(fs::is_symlink(strange("courses")));
    EXPECT_EQ(bytes_of(folder_ / "outside/map.json"), "mine");
}

TEST_F(links, that_go_round_in_a_map_end_no_command)
{
    ASSERT_EQ(run_program({"map", "hatch", "--width", "64", "--out", strange("courses")}).exit_code, 0);
    for (const char* name : {"courses/a", "courses/b", "courses/c"}) fs::create_directory_symlink(".", strange(name));
    const std::string level = folder_.write("strange/a.level.json", kLevel);
    EXPECT_EQ(run_program({"check", level}, 20.0).exit_code, 0);
    EXPECT_EQ(draw(level, folder_ / "a.png").exit_code, 0);
}

TEST_F(links, in_the_way_to_what_a_level_names_are_refused)
{
    ASSERT_EQ(run_program({"map", "hatch", "--width", "64", "--out", folder_ / "outside/courses"}).exit_code, 0);
    fs::create_directory_symlink("../outside/courses", strange("courses"));
    const std::string level = folder_.write("strange/a.level.json", kLevel);
    folder_.write("hatchway.project", "");
    for (const char* command : {"check", "render"}) {
        std::vector<std::string> words{command, level};
        if (words[0] == "render") words.insert(words.end(), {"--out", folder_ / "a.png"});
        const ProgramResult result = run_program(words, 20.0);
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_THAT(result.err, HasSubstr("goes through the link"));
    }
}

TEST_F(links, that_lead_back_from_two_builds_of_a_style_end_no_command)
{
    const std::string style = folder_ / "soft";
    ASSERT_EQ(run_program({"new-style", "soft", "--in", folder_.path().string()}).exit_code, 0);
    for (const char* build : {"build", "build-2"}) {
        fs::create_directories(fs::path(style) / build / "plugins");
        for (int i = 0; i < 3; ++i)
            fs::create_directory_symlink(style, fs::path(style) / build / "plugins" / ("soft" + std::to_string(i)));
        fs::create_directory_symlink(style, fs::path(style) / build / "plugins" / "soft");
    }
    // The library of another style stands in: it has the name of the folder of shaders that is a loop.
    fs::create_directories(folder_ / "plugins");
    fs::copy_file(HATCHWAY_BUILD_DIR "/lib/hatchway/plugins/photoreal.so", folder_ / "plugins/photoreal.so");
    fs::create_directory_symlink(style, folder_ / "plugins/photoreal");
    for (const auto& entry : fs::directory_iterator(HATCHWAY_SOURCE_DIR "/npr_plugins/photoreal"))
        fs::copy(entry.path(), style + "/" + entry.path().filename().string(), fs::copy_options::overwrite_existing);
    const ProgramResult result =
        run_program({"check", strange("prism.glb"), "--plugin-dir", folder_ / "plugins"}, 20.0);
    EXPECT_EQ(result.exit_code, 0) << result.err;
}

}  // namespace hw::test
