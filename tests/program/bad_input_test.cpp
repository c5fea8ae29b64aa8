// Every kind of bad input: exit code 2, one message that says where, what was found and what is allowed, nothing written.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "program/run_program.hpp"

namespace {
namespace fs = std::filesystem;
using hw::test::ProgramResult;
using hw::test::run_program;
using testing::Test;

class bad_input : public Test {
 protected:
    bad_input() { fs::copy_file(hw::test::kContent / "models" / "prism.glb", folder_.path() / "prism.glb"); }

    /// A level with more members after its first two.
    std::string level(const std::string& more)
    {
        return folder_.write("bad.level.json",
                             R"({"format": "hatchway-level/1", "scene": "prism.glb")" + (more.empty() ? "" : ", " + more) +
                                 "}");
    }
    ProgramResult render(const std::string& file, std::vector<std::string> more = {})
    {
        std::vector<std::string> arguments{"render", file, "--size", "64x48", "--out", out_};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_program(arguments);
    }
    void expect_refused(const ProgramResult& result, const std::vector<std::string>& words)
    {
        EXPECT_EQ(result.exit_code, 2) << result.err;
        EXPECT_EQ(result.out, "");
        for (const std::string& word : words) EXPECT_NE(result.err.find(word), std::string::npos) << word << "\n" << result.err;
        EXPECT_FALSE(fs::exists(out_));
    }

    hw::test::TemporaryFolder folder_;
    std::string out_ = folder_ / "out.png";
};

}  // namespace

TEST_F(bad_input, a_missing_file) { expect_refused(render(folder_ / "none.glb"), {"none.glb", "no such file"}); }

TEST_F(bad_input, a_folder_or_a_pipe_instead_of_a_file)
{
    expect_refused(render(folder_.path().string()), {folder_.path().string(), ".glb"});
    ASSERT_EQ(::mkfifo((folder_ / "pipe.glb").c_str(), 0600), 0);
    expect_refused(render(folder_ / "pipe.glb"), {"pipe.glb", "regular file"});
}

TEST_F(bad_input, a_level_that_is_no_json)
{
    expect_refused(render(folder_.write("bad.level.json", "{\"format\": ")), {"bad.level.json"});
    expect_refused(render(folder_.write("bad.level.json", "")), {"bad.level.json"});
}

TEST_F(bad_input, a_level_nested_too_deep)
{
    expect_refused(render(folder_.write("bad.level.json", std::string(200'000, '['))), {"bad.level.json"});
}

TEST_F(bad_input, an_unknown_key) { expect_refused(render(level(R"("camras": {})")), {"bad.level.json", "/camras", "cameras"}); }

TEST_F(bad_input, a_missing_model)
{
    const std::string file = folder_.write("bad.level.json", R"({"format": "hatchway-level/1", "scene": "none.glb"})");
    expect_refused(render(file), {"none.glb"});
}

TEST_F(bad_input, a_model_that_is_none)
{
    expect_refused(render(folder_.write("text.glb", "this is no model")), {"text.glb"});
    expect_refused(render(folder_.write("empty.glb", "")), {"empty.glb"});
}

TEST_F(bad_input, an_unknown_plugin)
{
    const std::string file = level(R"("styles": {"a": {"plugin": "crayon"}}, "assign": [{"nodes": "*", "style": "a"}])");
    expect_refused(render(file), {"bad.level.json", "/styles/a/plugin", "crayon", "pen_and_ink", "photoreal"});
}

TEST_F(bad_input, an_unknown_style)
{
    expect_refused(render(level(R"("assign": [{"nodes": "*", "style": "crayon"}])")),
                   {"bad.level.json", "/assign/0/style", "crayon", "pen_and_ink"});
    expect_refused(render(folder_ / "prism.glb", {"--style", "*=crayon"}), {"--style", "crayon", "pen_and_ink"});
}

TEST_F(bad_input, a_style_option_without_a_style)
{
    for (const char* text : {"crayon", "*=", "=photoreal"})
        expect_refused(render(folder_ / "prism.glb", {"--style", text}), {"--style", text, "GLOB=STYLE"});
}

TEST_F(bad_input, an_unknown_parameter)
{
    expect_refused(render(level(R"("styles": {"a": {"plugin": "pen_and_ink", "creese_deg": 4}})")),
                   {"bad.level.json", "/styles/a/creese_deg", "crease_deg"});
}

TEST_F(bad_input, a_parameter_out_of_range)
{
    expect_refused(render(level(R"("styles": {"a": {"plugin": "pen_and_ink", "crease_deg": 4000}})")),
                   {"bad.level.json", "/styles/a/crease_deg", "4000"});
    expect_refused(render(level(R"("styles": {"a": {"plugin": "pen_and_ink", "crease_deg": "wide"}})")),
                   {"/styles/a/crease_deg", "wide"});
}

TEST_F(bad_input, a_path_outside_of_the_project)
{
    for (const char* path : {"../../../etc/passwd", "/etc/passwd"}) {
        const std::string file =
            folder_.write("bad.level.json", std::string(R"({"format": "hatchway-level/1", "scene": ")") + path + "\"}");
        expect_refused(render(file), {"bad.level.json", "/scene", path, "project"});
    }
}

TEST_F(bad_input, a_map_that_is_not_there)
{
    expect_refused(render(level(R"("assign": [{"nodes": "*", "maps": {"ink": "maps/none"}}])")), {"bad.level.json", "maps/none"});
}

TEST_F(bad_input, an_unknown_camera_lists_those_that_exist)
{
    const std::string file = level(
        R"("cameras": {"door": {"position": [0, 1, 5], "look_at": [0, 1, 0]}, "well": {"position": [0, 1, 6], "look_at": [0, 1, 0]}})");
    expect_refused(render(file, {"--camera", "window"}), {"window", "door", "well"});
    expect_refused(render(file, {"--path", "round"}), {"round", "turntable"});
}

TEST_F(bad_input, sizes_and_numbers_that_make_no_picture)
{
    const std::string model = folder_ / "prism.glb";
    for (const char* size : {"0x10", "10", "10x", "x10", "-5x5", "99999x2", "10x10x10", "1e3x2"})
        expect_refused(run_program({"render", model, "--out", out_, "--size", size}), {"--size", size});
    expect_refused(render(model, {"--samples", "3"}), {"--samples", "1 or 4"});
    expect_refused(render(model, {"--samples", "many"}), {"--samples"});
    for (const char* eye : {"1,2", "1,2,3,4", "a,b,c", "nan,0,0", "1e400,0,0", "1;2;3"})
        expect_refused(render(model, {"--eye", eye, "--target", "0,0,0"}), {"--eye", eye});
    expect_refused(render(model, {"--eye", "1,2,3"}), {"--eye", "--target"});
    expect_refused(render(model, {"--eye", "1,2,3", "--target", "1,2,3"}), {"same place"});
    expect_refused(render(model, {"--fov-deg", "0"}), {"--fov-deg"});
    expect_refused(render(model, {"--fov-deg", "nan"}), {"--fov-deg"});
    expect_refused(render(model, {"--frames", "3"}), {"--frames", "path"});
    expect_refused(render(model, {"--path", "turntable", "--camera", "a"}), {"--camera", "--path"});
}

TEST_F(bad_input, an_output_that_cannot_be_written)
{
    const std::string model = folder_ / "prism.glb";
    expect_refused(run_program({"render", model, "--out", folder_ / "none/out.png"}), {"--out", "no folder"});
    expect_refused(run_program({"render", model, "--out", folder_.path().string()}), {"--out", "folder"});
    expect_refused(run_program({"render", model, "--out", folder_ / "out.jpg"}), {"--out", ".png"});
    expect_refused(run_program({"render", model, "--path", "turntable", "--out", folder_ / "none/out"}), {"--out"});
    expect_refused(run_program({"render", model, "--out", out_, "--json", folder_ / "none/a.json"}), {"--json"});
    expect_refused(run_program({"render", model, "--out", "/proc/out.png"}), {"/proc/out.png"});
}

TEST_F(bad_input, a_command_line_that_is_none)
{
    EXPECT_EQ(run_program({}).exit_code, 2);
    EXPECT_EQ(run_program({"paint"}).exit_code, 2);
    EXPECT_EQ(run_program({"render"}).exit_code, 2);
    EXPECT_EQ(run_program({"render", "a.glb", "--out", out_, "--sizes", "3x3"}).exit_code, 2);
    EXPECT_EQ(run_program({"measure"}).exit_code, 2);
    EXPECT_EQ(run_program({"silhouettes", folder_ / "prism.glb"}).exit_code, 2);
    EXPECT_EQ(run_program({"silhouettes", folder_ / "prism.glb", "--eye", "0,0,9", "--crease-deg", "-1"}).exit_code, 2);
    EXPECT_EQ(run_program({"new-style", "Bad Name", "--in", folder_.path().string()}).exit_code, 2);
}

TEST_F(bad_input, walking_without_a_display)
{
    const ProgramResult result =
        run_program({"walk", folder_ / "prism.glb"}, 60.0, {"DISPLAY", "WAYLAND_DISPLAY", "XDG_SESSION_TYPE"});
    expect_refused(result, {"display"});
}

TEST_F(bad_input, a_plugin_folder_that_is_not_there)
{
    expect_refused(render(folder_ / "prism.glb", {"--plugin-dir", folder_ / "none"}), {"none"});
}

TEST_F(bad_input, leaves_no_temporary_files)
{
    render(level(R"("camras": {})"));
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"bad.level.json", "prism.glb"}));
}
