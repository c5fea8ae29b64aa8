// What styles hand back as items is never followed before it is known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hatchway/gl/context.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/plugin_host/style_set.hpp"
#include "hatchway/render/renderer.hpp"
#include "hatchway/render/view/camera_view.hpp"
#include "tests/plugin_host/plugin_tests.hpp"

using namespace hw;
using namespace hw::test;
using testing::HasSubstr;

namespace {

/// A gray wall before a red sky.
Scene wall()
{
    Scene scene;
    MeshData mesh;
    mesh.positions = {{-2, -2, -4}, {2, -2, -4}, {2, 2, -4}, {-2, 2, -4}};
    mesh.normals.assign(4, glm::vec3(0, 0, 1));
    mesh.indices = {0, 1, 2, 0, 2, 3};
    scene.meshes.push_back(std::move(mesh));
    scene.materials.emplace_back();
    scene.nodes.push_back({.name = "wall", .path = "wall"});
    for (const glm::vec3& point : scene.meshes[0].positions) scene.bounds_world.add(glm::dvec3(point));
    scene.objects.push_back({.node = 0, .mesh = 0, .material = 0, .bounds_world = scene.bounds_world});
    return scene;
}

struct Drawn {
    std::vector<bool> shows_wall;  ///< In each of the frames.
    std::string log;
};

/// Two frames of the wall in the style makes_up_items.
Drawn drawn_from(const std::string& from)
{
    const auto context = make_headless_context();
    const Scene scene = wall();
    Renderer renderer(*context);
    StyleSet set(test_registry(),
                 [&](const std::filesystem::path& f) -> ProgramCache& { return renderer.program_cache(f); });
    Level level;
    level.styles["liar"] = {"makes_up_items", {{"from", {from, ""}}}, "/styles/liar"};
    set.set_level(level);
    SceneInput input;
    input.scene = &scene;
    input.objects.resize(1);
    input.objects[0].style = set.use("liar", "");
    input.styles = set.styles();
    input.background_srgb = {1.0f, 0.0f, 0.0f};
    renderer.load(std::move(input));
    Drawn drawn;
    set_log_level(LogLevel::error);
    testing::internal::CaptureStderr();
    for (int i = 0; i < 2; ++i) {
        renderer.draw(camera_view({{0, 0, 0}, {0, 0, -10}, 60}, {64, 64}, scene.bounds_world), {.samples = 1});
        drawn.shows_wall.push_back(renderer.read_picture().at(32, 32)[1] > 0);
    }
    drawn.log = testing::internal::GetCapturedStderr();
    set_log_level(LogLevel::off);
    EXPECT_TRUE(context->take_errors().empty());
    return drawn;
}

std::size_t count_of(const std::string& text, const std::string& what)
{
    std::size_t count = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
    return count;
}

}  // namespace

TEST(items, that_the_host_gave_are_drawn)
{
    const Drawn drawn = drawn_from("given");
    EXPECT_EQ(drawn.shows_wall, (std::vector<bool>{true, true}));
    EXPECT_EQ(drawn.log, "");
}

TEST(items, that_were_never_set_or_made_up_draw_nothing_and_the_log_says_so_once_with_the_style_s_name)
{
    for (const std::string from : {"unset", "bytes"}) {
        const Drawn drawn = drawn_from(from);
        EXPECT_EQ(drawn.shows_wall, (std::vector<bool>{false, false})) << from;
        EXPECT_EQ(count_of(drawn.log, "the style \"liar\" draws items that are not of this frame"), 1u) << drawn.log;
    }
}

TEST(items, of_an_earlier_frame_draw_nothing)
{
    const Drawn drawn = drawn_from("kept");
    EXPECT_EQ(drawn.shows_wall, (std::vector<bool>{true, false}));
    EXPECT_EQ(count_of(drawn.log, "the style \"liar\""), 1u) << drawn.log;
}
