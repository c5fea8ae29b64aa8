// Every kind of bad input: exit code 2, one message that says where, what was found and what is allowed, nothing
// written.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>

#include "tests/program/run_program.hpp"

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
        return folder_.write("bad.level.json", R"({"format": "hatchway-level/1", "scene": "prism.glb")" +
                                                   (more.empty() ? "" : ", " + more) + "}");
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
        for (const std::string& word : words)
            EXPECT_NE(result.err.find(word), std::string::npos) << word << "\n" << result.err;
        EXPECT_FALSE(fs::exists(out_));
    }

    hw::test::TemporaryFolder folder_;
    std::string out_ = folder_ / "out.png";
};

}  // namespace

TEST_F(bad_input, a_missing_file)
{
    expect_refused(render(folder_ / "none.glb"), {"none.glb", "no such file"});
}

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

TEST_F(bad_input, an_unknown_key)
{
    expect_refused(render(level(R"("camras": {})")), {"bad.level.json", "/camras", "cameras"});
}

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
    const std::string file =
        level(R"("styles": {"a": {"plugin": "crayon"}}, "assign": [{"nodes": "*", "style": "a"}])");
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

TEST_F(bad_input, a_glob_with_a_class_that_is_never_closed)
{
    expect_refused(render(level(R"("assign": [{"nodes": "Column_[0-", "style": "photoreal"}])")),
                   {"bad.level.json", "/assign/0/nodes", "Column_[0-", "never closed"});
    expect_refused(render(level(R"("assign": [{"materials": "[a", "style": "photoreal"}])")), {"/assign/0/materials"});
    expect_refused(render(folder_ / "prism.glb", {"--style", "[a=photoreal"}), {"--style", "[a", "never closed"});
}

TEST_F(bad_input, a_map_that_is_not_there)
{
    expect_refused(render(level(R"("assign": [{"nodes": "*", "maps": {"ink": "maps/none"}}])")),
                   {"bad.level.json", "maps/none"});
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

TEST_F(bad_input, styles_that_are_like_each_other)
{
    const std::string file = level(R"("styles": {"a": {"like": "b"}, "b": {"like": "a"}})");
    expect_refused(run_program({"check", file}), {"bad.level.json", "/styles/b/like", "is like itself"});
    const std::string wrong = level(R"("styles": {"a": {"like": "b"}, "b": {"plugin": "crayon"}})");
    expect_refused(run_program({"check", wrong}), {"bad.level.json", "/styles/a/like", "crayon", "pen_and_ink"});
}

TEST_F(bad_input, a_plugin_folder_that_is_not_there)
{
    expect_refused(render(folder_ / "prism.glb", {"--plugin-dir", folder_ / "none"}), {"none"});
}

TEST_F(bad_input, an_output_that_is_an_input)
{
    const std::string file = level("");
    const std::string model = folder_ / "prism.glb";
    const std::string portals = folder_.write("room.prt", "PRT1\n1\n0\n");
    fs::create_symlink(file, folder_ / "alias.json");
    const std::string before = hw::test::bytes_of(file) + hw::test::bytes_of(model) + hw::test::bytes_of(portals);
    const std::vector<std::vector<std::string>> commands{
        {"check", file, "--json", file},
        {"check", file, "--json", model},
        {"check", file, "--json", (folder_.path() / "." / "bad.level.json").string()},
        {"info", model, "--json", model},
        {"info", file, "--json", folder_ / "alias.json"},
        {"bake", file, "--out", file},
        {"bake", file, "--out", model},
        {"silhouettes", file, "--eye", "0,0,9", "--json", file},
        {"silhouettes", file, "--eye", "0,0,9", "--dump-mesh", model},
        {"pvs", portals, "--rows", portals},
        {"render", file, "--out", out_, "--json", file},
        {"render", file, "--out", out_, "--json", model},
        {"measure", "silhouettes", model, "--json", model}};
    for (const std::vector<std::string>& command : commands)
        expect_refused(run_program(command), {command[command.size() - 2] + ": is a file that is read"});
    EXPECT_EQ(hw::test::bytes_of(file) + hw::test::bytes_of(model) + hw::test::bytes_of(portals), before);
}

TEST_F(bad_input, an_output_that_is_a_map_of_the_level)
{
    fs::create_directory(folder_ / "courses");
    ASSERT_EQ(run_program({"map", "hatch", "--out", folder_ / "courses"}).exit_code, 0);
    const std::string file =
        level(R"("assign": [{"nodes": "*", "style": "pen_and_ink", "maps": {"hatch": "./courses"}}])");
    const std::string map = folder_ / "courses/level_0.png";
    const std::string before = hw::test::bytes_of(map);
    expect_refused(run_program({"render", file, "--size", "64x48", "--out", map}), {"--out: is a file that is read"});
    expect_refused(render(file, {"--json", map}), {"--json: is a file that is read"});
    EXPECT_EQ(hw::test::bytes_of(map), before);
}

TEST_F(bad_input, two_outputs_that_are_the_same_file)
{
    const std::string model = folder_ / "prism.glb";
    expect_refused(render(model, {"--json", out_}), {"--json", "--out", "is the file of"});
    expect_refused(
        run_program({"silhouettes", model, "--eye", "0,0,9", "--json", folder_ / "a", "--dump-mesh", folder_ / "a"}),
        {"--dump-mesh: is the file of --json"});
    expect_refused(run_program({"map", "hatch", "--out", folder_ / "new", "--preview", folder_ / "new/level_0.png"}),
                   {"--preview: is the file of --out"});
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"prism.glb"});
}

TEST_F(bad_input, a_number_that_is_none_or_out_of_range)
{
    const std::string map = folder_ / "new";
    const std::string model = folder_ / "prism.glb";
    for (const char* number : {"nan", "inf", "-1", "1e400", "4x", ""}) {
        expect_refused(run_program({"map", "hatch", "--out", map, "--line", number}),
                       {"--line", number, "expected 0.2 to 4"});
        expect_refused(run_program({"map", "tonal", "--out", map, "--pen", number}), {"--pen", "expected 0.5 to 8"});
        expect_refused(run_program({"map", "tonal", "--out", map, "--angle-spread-deg", number}), {"expected 0 to 45"});
        expect_refused(run_program({"map", "tonal", "--out", map, "--size-m", number}), {"expected 0.001 to 1000"});
        expect_refused(run_program({"bake", model, "--luxels-per-m", number}), {"expected 0.01 to 1000"});
        expect_refused(render(model, {"--frames", number, "--path", "turntable"}),
                       {"--frames", "expected 1 to 100000"});
    }
    expect_refused(render(model, {"--time-s", "nan"}), {"--time-s", "expected"});
    expect_refused(run_program({"map", "hatch", "--out", map, "--width", "65"}),
                   {"--width", "65", "64, 128", "or 4096"});
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"prism.glb"});
}

TEST_F(bad_input, a_name_longer_than_a_file_system_takes)
{
    const std::string long_name(5000, 'n');
    const std::string folder = folder_.path().string();
    const std::string model = folder_ / "prism.glb";
    expect_refused(run_program({"new-style", std::string(300, 'n'), "--in", folder}), {"too long"});
    expect_refused(run_program({"new-style", "pencil", "--in", "/" + long_name}), {"--in"});
    expect_refused(run_program({"schema", "--plugin-dir", "/" + long_name}), {"nnn"});
    expect_refused(render("/" + long_name + ".glb"), {"nnn"});
    expect_refused(render(model, {"--json", "/" + long_name + "/a.json"}), {"--json"});
    expect_refused(run_program({"render", model, "--path", "turntable", "--out", folder + "/" + long_name}), {"nnn"});
}

TEST_F(bad_input, a_map_whose_folder_or_preview_cannot_be_written)
{
    expect_refused(run_program({"map", "hatch", "--out", folder_ / "new", "--preview", folder_ / "none/p.png"}),
                   {"--preview", "no folder"});
    expect_refused(run_program({"map", "hatch", "--out", folder_ / "none/new"}), {"--out", "no folder"});
    expect_refused(run_program({"map", "hatch", "--out", folder_ / "prism.glb"}), {"--out", "is no folder"});
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"prism.glb"});
    const std::string map = folder_ / "new";
    const ProgramResult good = run_program({"map", "hatch", "--out", map + "/", "--preview", map + "/preview.png"});
    EXPECT_EQ(good.exit_code, 0) << good.err;
    EXPECT_TRUE(fs::exists(map + "/preview.png"));
}

TEST_F(bad_input, a_name_that_makes_no_style)
{
    const std::string folder = folder_.path().string();
    for (const char* name : {"class", "int", "xor_eq"})
        expect_refused(run_program({"new-style", name, "--in", folder}), {name, "word of C++"});
    expect_refused(run_program({"new-style", "photoreal", "--in", folder}), {"photoreal", "taken"});
    expect_refused(run_program({"new-style", "pencil", "--in", folder_ / "none"}), {"--in", "no folder"});
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"prism.glb"});
}

TEST_F(bad_input, a_word_that_nobody_knows_is_named_in_one_line)
{
    const auto expect_line = [this](const std::vector<std::string>& command, const std::vector<std::string>& words) {
        const ProgramResult result = run_program(command);
        expect_refused(result, words);
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    };
    expect_line({"nope"}, {"unknown command nope", "render", "new-style"});
    expect_line({"map", "nope"}, {"unknown command nope", "hatch", "tonal"});
    expect_line({"render", "a.glb", "--nope"}, {"hatchway render: unknown option --nope", "--out", "--samples"});
    expect_line({"info", "a.glb", "b.glb"}, {"one word too many: b.glb"});
    expect_line({}, {"no command", "render"});
    expect_line({"render", "a.glb"}, {"--out is required", "hatchway render --help"});
    expect_line({"bake", "a.glb", "--quality", "best"}, {"--quality", "best", "expected draft or final"});
}

TEST_F(bad_input, a_picture_larger_than_any_device_draws)
{
    const ProgramResult result = run_program({"render", folder_ / "prism.glb", "--out", out_, "--size", "16384x16384"});
    expect_refused(result, {"--size 16384x16384", "at most", "pixels"});
    EXPECT_LT(result.seconds, 5.0);
}

TEST_F(bad_input, an_option_without_a_value)
{
    const std::string model = folder_ / "prism.glb";
    for (const char* option : {"--camera", "--path", "--eye", "--json", "--style", "--plugin-dir", "--samples"})
        expect_refused(render(model, {option, ""}), {option});
    expect_refused(run_program({"bake", model, "--out", ""}), {"--out", "is empty"});
}

TEST_F(bad_input, a_style_option_that_names_nothing_is_warned_of)
{
    const ProgramResult idle =
        render(folder_ / "prism.glb", {"--style", "*=photoreal", "--style", "no_such_node=photoreal"});
    EXPECT_EQ(idle.exit_code, 0) << idle.err;
    EXPECT_NE(idle.err.find("--style 2: \"no_such_node\" names nothing in the model"), std::string::npos) << idle.err;
    EXPECT_EQ(idle.err.find("--style 1"), std::string::npos) << idle.err;
}

TEST_F(bad_input, a_section_that_no_report_has)
{
    expect_refused(run_program({"report", "--out", folder_.path().string(), "--only", "zz"}),
                   {"--only zz", "silhouettes", "lightmap"});
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"prism.glb"});
}

TEST_F(bad_input, leaves_no_temporary_files)
{
    render(level(R"("camras": {})"));
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"bad.level.json", "prism.glb"}));
}
