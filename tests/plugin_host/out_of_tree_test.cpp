// Builds every built-in style, and a style fresh from new-style, against an installation, the way a stranger would: so
// no style has private hooks into the engine.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "hatchway/core/files/files.hpp"
#include "hatchway/plugin_host/make_style.hpp"
#include "hatchway/plugin_host/new_style.hpp"
#include "tests/plugin_host/plugin_tests.hpp"

using namespace hw;
using namespace hw::test;

namespace {

namespace fs = std::filesystem;

/// Runs cmake with these arguments; its output stands in `log` when it fails.
bool run_cmake(const std::string& arguments, const fs::path& log)
{
    return std::system(("\"" HATCHWAY_CMAKE "\" " + arguments + " > \"" + log.string() + "\" 2>&1").c_str()) == 0;
}

std::string text_of(const fs::path& log)
{
    return read_text_file(log, 1 << 24);
}

/// The smallest style as docs/write_a_style.md shows it.
std::string smallest_style()
{
    const std::string page = read_text_file(HATCHWAY_SOURCE_DIR "/docs/write_a_style.md", 1 << 20);
    const std::string begin = "<!-- smallest style -->\n```cpp\n";
    const std::size_t at = page.find(begin) + begin.size();
    return page.substr(at, page.find("```", at) - at);
}

void write_smallest_style(const fs::path& folder)
{
    fs::create_directories(folder);
    std::ofstream(folder / "flat.cpp") << smallest_style();
    std::ofstream(folder / "CMakeLists.txt") << "add_npr_plugin(flat)\n";
}

/// One project with all styles, so that the compiler and the package are looked for once.
void write_project(const fs::path& folder, const std::vector<fs::path>& styles)
{
    std::ofstream file(folder / "CMakeLists.txt");
    file << "cmake_minimum_required(VERSION 3.25)\nproject(styles LANGUAGES CXX)\nfind_package(hatchway REQUIRED)\n";
    for (const fs::path& style : styles)
        file << "add_subdirectory(\"" << style.string() << "\" " << style.filename().string() << ")\n";
}

}  // namespace

TEST(out_of_tree, every_built_in_style_and_a_new_one_build_against_an_installation_and_load)
{
    const fs::path root = fs::path(HATCHWAY_BUILD_DIR) / "tests" / "plugin_host" / "out_of_tree";
    fs::remove_all(root);
    fs::create_directories(root / "source");
    const fs::path log = root / "log.txt";
    const fs::path prefix = root / "prefix";
    for (const char* component : {"library", "development"})
        ASSERT_TRUE(run_cmake(
            "--install \"" HATCHWAY_BUILD_DIR "\" --prefix \"" + prefix.string() + "\" --component " + component, log))
            << text_of(log);

    std::vector<fs::path> styles;
    for (const fs::directory_entry& entry : fs::directory_iterator(HATCHWAY_SOURCE_DIR "/npr_plugins"))
        if (fs::exists(entry.path() / "CMakeLists.txt")) styles.push_back(entry.path());
    write_new_style("fresh", root / "source");
    styles.push_back(root / "source" / "fresh");
    write_smallest_style(root / "source" / "flat");
    styles.push_back(root / "source" / "flat");
    write_project(root / "source", styles);

    ASSERT_TRUE(run_cmake("-S \"" + (root / "source").string() + "\" -B \"" + (root / "build").string() +
                              "\" -DCMAKE_CXX_FLAGS=-O0 -DCMAKE_PREFIX_PATH=\"" + prefix.string() + "\"",
                          log))
        << text_of(log);
    ASSERT_TRUE(run_cmake("--build \"" + (root / "build").string() + "\"", log)) << text_of(log);

    const PluginRegistry registry({.has_installed = false, .folders = {root / "build" / "plugins"}});
    EXPECT_EQ(registry.plugins().size(), styles.size());
    for (const RefusedPlugin& refused : registry.refused()) ADD_FAILURE() << refused.library << ": " << refused.why;
    const Plugin& fresh = require_plugin(registry, "fresh", PluginKind::style, {});
    EXPECT_TRUE(fs::exists(fresh.shader_folder / "fresh.frag"));
    EXPECT_NE(make_style(fresh, {}, {}), nullptr);
    EXPECT_NE(make_style(require_plugin(registry, "flat", PluginKind::style, {}), {}, {}), nullptr);
    EXPECT_LE(lines_of_code(smallest_style()), 12);
}
