// Meshes and scans open wherever a model does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/program/run_program.hpp"

namespace {

using hw::test::bytes_of;
using hw::test::run_program;
using hw::test::TemporaryFolder;

/// A tent of two coloured sides.
const std::string kOff =
    "COFF\n4 2 0\n-1 0 1 255 0 0\n-1 0 -1 255 0 0\n0 2 0 255 255 0\n1 0 0 0 0 255\n3 0 3 2\n3 3 1 2\n";
const std::string kObj = "o Tent\ng Front\nv -1 0 1\nv -1 0 -1\nv 0 2 0\nv 1 0 0\nf 1 4 3\ng Back\nf 4 2 3\n";

}  // namespace

TEST(mesh_files, open_in_every_command_that_takes_a_model)
{
    const TemporaryFolder folder;
    for (const std::string& file : {folder.write("tent.off", kOff), folder.write("tent.obj", kObj)}) {
        const std::vector<std::vector<std::string>> commands{
            {"info", file},
            {"check", file},
            {"render", file, "--size", "64x48", "--out", folder / "a.png"},
            {"render", file, "--size", "64x48", "--style", "*=pen_and_ink", "--out", folder / "b.png"},
            {"render", file, "--size", "64x48", "--style", "*=hybrid", "--out", folder / "c.png"},
            {"lines", file, "--out", folder / "a.svg"},
            {"silhouettes", file, "--eye", "0,1,5"},
            {"compile", file, "--out", folder / "a.compiled"},
        };
        for (const std::vector<std::string>& command : commands) {
            const auto result = run_program(command);
            EXPECT_EQ(result.exit_code, 0) << command[0] << ' ' << file << '\n' << result.err;
        }
        EXPECT_THAT(bytes_of(folder / "a.svg"), testing::HasSubstr("<path"));
    }
}

TEST(mesh_files, groups_of_an_obj_file_are_named_by_rules_of_a_level)
{
    const TemporaryFolder folder;
    folder.write("tent.obj", kObj);
    const auto level = [&](const std::string& nodes) {
        return folder.write("a.level.json", R"({"format": "hatchway-level/1", "scene": "tent.obj", "styles": {"ink":
            {"plugin": "pen_and_ink"}}, "assign": [{"nodes": ")" +
                                                nodes + R"(", "style": "ink"}]})");
    };
    const auto known = run_program({"check", level("Tent/Back")});
    EXPECT_EQ(known.exit_code, 0) << known.err;
    EXPECT_THAT(run_program({"info", level("Tent/Back"), "--nodes"}).out, testing::HasSubstr("Tent/Back"));
}

TEST(mesh_files, that_are_broken_end_in_one_message_and_nothing_written)
{
    const TemporaryFolder folder;
    const std::string file = folder.write("a.off", "OFF\n3 4000000000 0\n");
    const auto result = run_program({"render", file, "--out", folder / "a.png"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, testing::HasSubstr("a.off: line 2"));
    EXPECT_THAT(folder.names(), testing::ElementsAre("a.off"));
    const auto unknown = run_program({"render", folder.write("a.xyz", "0 0 0"), "--out", folder / "a.png"});
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_THAT(unknown.err, testing::HasSubstr(".ply"));
}
