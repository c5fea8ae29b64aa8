// The hash that keeps plugins apart which saw other headers covers every header that a style sees.
#include <gtest/gtest.h>

#include <cstdlib>

#include "hatchway/core/files/files.hpp"
#include "hatchway/style/style.hpp"
#include "tests/temporary_folder.hpp"

namespace {
namespace fs = std::filesystem;

/// A project that has cmake/style_headers.cmake write the hash of its own few headers.
class header_hash : public testing::Test {
 protected:
    header_hash()
    {
        folder_.write("CMakeLists.txt",
                      "cmake_minimum_required(VERSION 3.25)\nproject(hash LANGUAGES NONE)\n"
                      "include(\"" HATCHWAY_SOURCE_DIR
                      "/cmake/style_headers.cmake\")\n"
                      "hatchway_write_header_hash(\"${CMAKE_BINARY_DIR}/hash.hpp\")\n");
        header("style/style.hpp", "#include <vector>\n#include \"hatchway/param/visitor.hpp\"\n");
        header("param/visitor.hpp", "#pragma once\n#include \"hatchway/core/box.hpp\"  // for boxes\n");
        header("core/box.hpp", "struct Box {};\n");
        header("core/error.hpp", "struct Error {};\n");
        header("render/renderer.hpp", "struct Renderer {};\n");
    }
    void header(const std::string& name, const std::string& text) { folder_.write("scenegraph/" + name, text); }
    std::string hash()
    {
        const std::string folder = folder_.path().string();
        const std::string command =
            "\"" HATCHWAY_CMAKE "\" -S \"" + folder + "\" -B \"" + folder + "/build\" > /dev/null 2>&1";
        EXPECT_EQ(std::system(command.c_str()), 0);
        return hw::read_text_file(folder_.path() / "build/hash.hpp", 10000);
    }

    TemporaryFolder folder_;
};

}  // namespace

TEST_F(header_hash, changes_with_each_header_that_a_style_sees_and_with_no_other)
{
    const std::string before = hash();
    EXPECT_NE(before.find("#define HW_HEADER_HASH \""), std::string::npos);
    header("render/renderer.hpp", "struct Renderer { int x; };\n");
    EXPECT_EQ(hash(), before);
    for (const char* name : {"style/style.hpp", "param/visitor.hpp", "core/box.hpp", "core/error.hpp"}) {
        const std::string text = hw::read_text_file(folder_.path() / "scenegraph" / name, 10000);
        header(name, text + "// changed\n");
        EXPECT_NE(hash(), before) << name;
        header(name, text);
        EXPECT_EQ(hash(), before) << name;
    }
}

TEST_F(header_hash, is_in_what_a_plugin_and_the_program_are_compared_by)
{
    EXPECT_EQ(std::string(HW_HEADER_HASH).size(), 16u);
    EXPECT_NE(std::string(HW_PLUGIN_BUILD).find("headers " HW_HEADER_HASH), std::string::npos);
}
