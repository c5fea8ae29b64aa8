// Names of a stranger's model that a terminal would obey, in all that the program writes.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "hatchway/core/plain_text.hpp"
#include "tests/program/run_program.hpp"

namespace hw::test {
namespace {
using nlohmann::json;

const std::string kName =
    "\x1b[31mred\x1b]0;title\x07\xc2\x9b"
    "2J\r\nfake\x7f\xe2\x80\xae";

/// One triangle, everything of it with that name.
std::string hostile_model(const TemporaryFolder& folder)
{
    const json model = {
        {"asset", {{"version", "2.0"}}},
        {"scenes", {{{"nodes", {0}}}}},
        {"nodes", {{{"mesh", 0}, {"name", kName}, {"extras", {{"hatchway.style", kName}}}}}},
        {"cameras", {{{"name", kName}, {"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}}}},
        {"materials", {{{"name", kName}}}},
        {"meshes", {{{"name", kName}, {"primitives", {{{"attributes", {{"POSITION", 0}}}, {"material", 0}}}}}}},
        {"accessors",
         {{{"bufferView", 0},
           {"componentType", 5126},
           {"count", 3},
           {"type", "VEC3"},
           {"min", {0.0, 0.0, 0.0}},
           {"max", {1.0, 1.0, 0.0}}}}},
        {"bufferViews", {{{"buffer", 0}, {"byteLength", 36}}}},
        {"buffers",
         {{{"byteLength", 36},
           {"uri", "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}}}}};
    return folder.write("a.gltf", model.dump());
}

/// Whether a text is lines of plain text.
bool is_plain(const std::string& text)
{
    std::size_t start = 0;
    for (std::size_t end = 0; (end = text.find('\n', start)) != std::string::npos; start = end + 1)
        if (hw::plain_text(text.substr(start, end - start)) != text.substr(start, end - start)) return false;
    return start == text.size();
}

}  // namespace

TEST(names, of_a_model_reach_no_terminal_as_they_are)
{
    const TemporaryFolder folder;
    const std::string model = hostile_model(folder);
    const std::string level =
        folder.write("a.level.json", json({{"format", "hatchway-level/1"},
                                           {"scene", "a.gltf"},
                                           {"styles", {{kName, {{"plugin", "photoreal"}}}}},
                                           {"cameras", {{kName, {{"position", {0, 0, 5}}, {"look_at", {0, 0, 0}}}}}}})
                                         .dump());
    const std::vector<std::vector<std::string>> commands{
        {"info", model, "--nodes", "--json", folder / "i.json"},
        {"check", model},
        {"check", level, "--json", folder / "c.json"},
        {"render", level, "--camera", "none", "--out", folder / "a.png"},
        {"render", level, "--size", "32x32", "--stats", "--show", "leaves", "--out", folder / ("\x1b[31m.png")},
        {"lines", level, "--style", "*=pen_and_ink", "--size", "32x32", "--out", folder / "a.svg"},
        {"check", folder / ("\x1b[31m\n.json")},
        {"\x1b[31m"},
        {"check", "--\x1b[31m"},
        {"render", model, "--style", "*=\x1b[31m", "--out", folder / "a.png"}};
    int told = 0;
    for (const std::vector<std::string>& command : commands) {
        const ProgramResult result = run_program(command);
        EXPECT_TRUE(is_plain(result.out)) << command[0] << ": " << hw::plain_text(result.out);
        EXPECT_TRUE(is_plain(result.err)) << command[0] << ": " << hw::plain_text(result.err);
        told += (result.out + result.err).find("\\x1b[31m") != std::string::npos;
    }
    EXPECT_GE(told, 7) << "the names stand there, written out";
    for (const char* file : {"i.json", "c.json"}) EXPECT_TRUE(is_plain(bytes_of(folder / file))) << file;
}

}  // namespace hw::test
