#include "hatchway/gl/shader_text.hpp"
#include "hatchway/gl/headless_context.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "hatchway/core/error.hpp"
#include "hatchway/gl/context.hpp"
#include "hatchway/gl/gpu_program.hpp"
#include "tests/temporary_folder.hpp"

namespace hw {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Two folders of shaders that go with the test.
class ShaderFolders : public testing::Test {
 protected:
    ShaderFolders() : folders_{root_.path() / "style", root_.path() / "shared"}
    {
        for (const fs::path& folder : folders_) fs::create_directories(folder);
        write("shared", "full.vert", "void main() { gl_Position = vec4(0.0); }\n");
    }

    void write(const std::string& folder, const std::string& name, const std::string& text) const
    {
        root_.write(folder + "/" + name, text);
    }
    ShaderText load(const std::string& name) const { return load_shader(name, folders_, "#define FROM_HOST 1\n"); }
    std::string message_of(const std::string& name) const
    {
        try {
            load(name);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

    TemporaryFolder root_;
    std::vector<fs::path> folders_;
};

TEST_F(ShaderFolders, an_include_is_found_in_the_style_first_then_in_the_shared_folder)
{
    write("style", "a.frag", "#include \"own.glsl\"\n#include \"both.glsl\"\n#include \"shared.glsl\"\n");
    write("style", "own.glsl", "// own\n");
    write("style", "both.glsl", "// of the style\n");
    write("shared", "both.glsl", "// of the engine\n");
    write("shared", "shared.glsl", "// shared\n");
    const ShaderText shader = load("a.frag");
    EXPECT_THAT(shader.text, HasSubstr("// own"));
    EXPECT_THAT(shader.text, HasSubstr("// of the style"));
    EXPECT_THAT(shader.text, Not(HasSubstr("// of the engine")));
    EXPECT_THAT(shader.text, HasSubstr("// shared"));
}

TEST_F(ShaderFolders, a_file_is_included_once_however_often_it_is_named)
{
    write("style", "a.frag", "#include \"b.glsl\"\n#include \"b.glsl\"\n");
    write("style", "b.glsl", "#include \"b.glsl\"\nint only_once;\n");
    const std::string text = load("a.frag").text;
    EXPECT_EQ(text.find("only_once"), text.rfind("only_once"));
}

TEST_F(ShaderFolders, a_missing_include_names_file_and_line)
{
    write("style", "a.frag", "\n\n#include \"nowhere.glsl\"\n");
    const std::string message = message_of("a.frag");
    EXPECT_THAT(message, HasSubstr("a.frag"));
    EXPECT_THAT(message, HasSubstr("line 3"));
    EXPECT_THAT(message, HasSubstr("nowhere.glsl"));
}

TEST_F(ShaderFolders, a_name_that_leaves_the_folders_is_refused)
{
    write("style", "a.frag", "#include \"../shared/full.vert\"\n");
    EXPECT_THAT(message_of("a.frag"), HasSubstr("no shader file"));
    EXPECT_THAT(message_of("/etc/passwd"), HasSubstr("no shader file"));
}

TEST_F(ShaderFolders, a_chain_of_includes_deeper_than_sixteen_is_refused)
{
    for (int i = 0; i < 20; ++i)
        write("style", fmt::format("f{}.glsl", i), fmt::format("#include \"f{}.glsl\"\n", i + 1));
    write("style", "f20.glsl", "\n");
    EXPECT_THAT(message_of("f0.glsl"), HasSubstr("too deep"));
}

TEST_F(ShaderFolders, a_compile_error_is_located_in_the_included_file)
{
    write("style", "a.frag", "#include \"wrong.glsl\"\nout vec4 colour;\nvoid main() { colour = vec4(1.0); }\n");
    write("style", "wrong.glsl", "// first\n// second\nfloat f() { return undeclared_name; }\n");
    for (const bool is_es : {false, true}) {
        const auto context = make_headless_context({.is_es = is_es});
        try {
            GpuProgram(load("full.vert"), load("a.frag"), is_es);
            FAIL() << "it compiled";
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr("wrong.glsl:3:"));
            EXPECT_THAT(error.what(), HasSubstr("undeclared_name"));
        }
        EXPECT_THAT(context->take_errors(), testing::IsEmpty());
    }
}

TEST_F(ShaderFolders, a_line_after_an_include_keeps_its_number)
{
    write("style", "a.frag", "#include \"good.glsl\"\n\nwrong here;\n");
    write("style", "good.glsl", "// 1\n// 2\n// 3\n// 4\n");
    const auto context = make_headless_context();
    try {
        GpuProgram(load("full.vert"), load("a.frag"), false);
        FAIL() << "it compiled";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("a.frag:3:"));
    }
}

TEST(located_message, reads_the_forms_of_several_drivers)
{
    const ShaderText shader{"", {"defines", "a.frag", "b.glsl"}};
    EXPECT_EQ(located_message("2:14(5): error: wrong type", shader), "b.glsl:14: error: wrong type");
    EXPECT_EQ(located_message("1(7) : error C1008: undefined", shader), "a.frag:7: error C1008: undefined");
    EXPECT_EQ(located_message("ERROR: 2:9: 'x' : undeclared", shader), "b.glsl:9: 'x' : undeclared");
    EXPECT_EQ(located_message("nothing known", shader), "a.frag: nothing known");
}

}  // namespace
}  // namespace hw
