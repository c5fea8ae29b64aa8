// Builds every built-in style, the examples of the manual and a style fresh from new-style against an installation, the
// way a stranger would: so no style has private hooks into the engine. Draws the examples.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "hatchway/core/files/files.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/io/images/images.hpp"
#include "hatchway/plugin_host/make_style.hpp"
#include "hatchway/plugin_host/new_style.hpp"
#include "hatchway/plugin_host/style_set.hpp"
#include "hatchway/render/renderer.hpp"
#include "hatchway/render/view/camera_view.hpp"
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

/// A floor under the eye, drawn by one of the examples.
class ExampleStage {
 public:
    explicit ExampleStage(const PluginRegistry& registry)
        : context_(make_headless_context()),
          renderer_(*context_, read_image),
          styles_(registry, [this](const fs::path& folder) -> ProgramCache& { return renderer_.program_cache(folder); })
    {
        MeshData floor;
        for (const glm::vec3& corner :
             {glm::vec3(-3, 0, 3), glm::vec3(3, 0, 3), glm::vec3(3, 0, -3), glm::vec3(-3, 0, -3)}) {
            floor.positions.push_back(corner);
            floor.normals.emplace_back(0.0f, 1.0f, 0.0f);
            scene_.bounds_world.add(glm::dvec3(corner));
        }
        floor.indices = {0, 1, 2, 0, 2, 3};
        scene_.meshes.push_back(std::move(floor));
        scene_.materials.emplace_back().base_colour = glm::vec4(0.5f, 0.7f, 0.3f, 1.0f);
        scene_.nodes.push_back({.name = "floor", .path = "floor"});
        scene_.objects.push_back({.node = 0, .mesh = 0, .material = 0, .bounds_world = scene_.bounds_world});
    }
    ~ExampleStage() { EXPECT_THAT(context_->take_errors(), testing::IsEmpty()); }

    Pixels drawn(const std::string& style, std::optional<ImageKey> shown = {})
    {
        SceneInput input;
        input.scene = &scene_;
        input.objects.resize(1);
        input.objects[0].style = styles_.use(style, "");
        input.styles = styles_.styles();
        input.image_passes = styles_.image_passes();
        renderer_.load(std::move(input));
        FrameOptions options{.samples = 1};
        options.shown_image = std::move(shown);
        renderer_.draw(camera_view({{0, 1.5, 4}, {0, 0, 0}, 60.0}, {128, 96}, scene_.bounds_world), options);
        EXPECT_THAT(styles_.failures(), testing::IsEmpty());
        return renderer_.read_picture();
    }

 private:
    std::unique_ptr<Context> context_;
    Renderer renderer_;
    StyleSet styles_;
    Scene scene_;
};

/// Pixels that differ from the one to their right.
int unlike_neighbours(const Pixels& pixels)
{
    int count = 0;
    for (int y = 0; y < pixels.height; ++y)
        for (int x = 0; x + 1 < pixels.width; ++x) count += *pixels.at(x, y) != *pixels.at(x + 1, y) ? 1 : 0;
    return count;
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
    for (const fs::directory_entry& entry : fs::directory_iterator(HATCHWAY_SOURCE_DIR "/docs/examples"))
        styles.push_back(entry.path());
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

    ::setenv("XDG_CACHE_HOME", (root / "cache").c_str(), 1);  // each is tried first
    const PluginRegistry registry({.has_installed = false, .folders = {root / "build" / "plugins"}});
    ::unsetenv("XDG_CACHE_HOME");
    EXPECT_EQ(registry.plugins().size(), styles.size());
    for (const RefusedPlugin& refused : registry.refused()) ADD_FAILURE() << refused.library << ": " << refused.why;
    const Plugin& fresh = require_plugin(registry, "fresh", PluginKind::style, {});
    EXPECT_TRUE(fs::exists(fresh.shader_folder / "fresh.frag"));
    ExampleStage stage(registry);
    EXPECT_GT(unlike_neighbours(stage.drawn("fresh")), 100) << "two colours and lines";
    EXPECT_LT(stage.drawn("flat").at(64, 80)[1], 250) << "plain gray, not the paper around it";
    EXPECT_GT(unlike_neighbours(stage.drawn("charcoal")), 100) << "lines on paper";
    const Pixels wash = stage.drawn("soft_wash");
    EXPECT_GT(wash.at(64, 80)[1], wash.at(64, 80)[0] + 10) << "the floor's colour";
    EXPECT_GT(wash.at(64, 80)[0], wash.at(64, 80)[2] + 10);
    EXPECT_GT(unlike_neighbours(stage.drawn("on_paper")), 5000) << "grain all over the floor";
    const Pixels nearness = stage.drawn("charcoal", ImageKey{"nearness", {{"far_m", 8.0}}});
    EXPECT_GT(nearness.at(64, 90)[0], nearness.at(64, 60)[0] + 20) << "the floor comes nearer";
    EXPECT_EQ(nearness.at(64, 1)[0], 0) << "there is nothing";
    EXPECT_EQ(lines_of_code(smallest_style()), 8) << "as the page says";
}
