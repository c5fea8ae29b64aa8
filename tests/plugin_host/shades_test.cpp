// How styles shade whose picture can be worked out: halftone's mean ink, cartoon's bands and the map that smooths them.
#include <gtest/gtest.h>

#include <cmath>

#include "hatchway/gl/context.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/io/images/images.hpp"
#include "hatchway/plugin_host/style_set.hpp"
#include "hatchway/render/renderer.hpp"
#include "hatchway/render/view/camera_view.hpp"
#include "tests/plugin_host/plugin_tests.hpp"

using namespace hw;
using namespace hw::test;

namespace {

constexpr glm::ivec2 kSize{192, 144};

/// A quarter of an upright cylinder around the eye's axis, lit from the right: light falls evenly along each row.
Scene bent_wall(float white)
{
    Scene scene;
    scene.materials.push_back({.base_colour = glm::vec4(glm::vec3(white), 1.0f)});
    scene.nodes.push_back({.name = "all", .path = "all"});
    MeshData mesh;
    constexpr int kColumns = 32;
    for (int i = 0; i <= kColumns; ++i) {
        const float angle = glm::radians(-80.0f + 160.0f * static_cast<float>(i) / kColumns);
        for (const float y : {-4.0f, 4.0f}) {
            mesh.positions.emplace_back(2.0f * std::sin(angle), y, 2.0f * std::cos(angle));
            mesh.normals.emplace_back(std::sin(angle), 0.0f, std::cos(angle));
        }
        const auto at = static_cast<std::uint32_t>(2 * i);
        if (i > 0)
            for (const std::uint32_t k : {at - 2, at, at + 1, at - 2, at + 1, at - 1}) mesh.indices.push_back(k);
    }
    mesh.has_own_normals = true;
    Object object{.node = 0, .mesh = 0, .material = 0};
    for (const glm::vec3& point : mesh.positions) object.bounds_world.add(glm::dvec3(point));
    scene.bounds_world = object.bounds_world;
    scene.meshes.push_back(std::move(mesh));
    scene.objects.push_back(object);
    return scene;
}

using Params = std::map<std::string, ParamValue>;

/// The wall in a style, without lines, one sample a pixel.
Pixels drawn(const std::string& plugin, const Params& params, float white = 1.0f)
{
    const auto context = make_headless_context();
    const Scene scene = bent_wall(white);
    Renderer renderer(*context, read_image);
    StyleSet set(test_registry(),
                 [&](const std::filesystem::path& folder) -> ProgramCache& { return renderer.program_cache(folder); });
    Level level;
    StyleDesc desc{.plugin = plugin};
    for (const auto& [name, value] : params) desc.params[name] = {value, "/styles/" + name};
    desc.params["lines_from"] = {std::string("none"), "/styles/lines_from"};
    level.styles["wall"] = desc;
    set.set_level(level);
    SceneInput input;
    input.scene = &scene;
    input.objects.resize(1);
    input.objects[0].style = set.use("wall", "");
    input.styles = set.styles();
    input.image_passes = set.image_passes();
    input.exposure_ev = 14.0f;
    input.lights = {{.type = LightType::sun,
                     .intensity = 60000.0f,
                     .direction_world = glm::normalize(glm::dvec3(-1.0, 0.0, -0.3))}};
    renderer.load(std::move(input));
    renderer.draw(camera_view({{0, 0, 6}, {0, 0, 0}, 40}, kSize, scene.bounds_world), {.samples = 1});
    EXPECT_TRUE(context->take_errors().empty());
    EXPECT_TRUE(renderer.remarks().empty()) << renderer.remarks().front();
    return renderer.read_picture();
}

double linear(std::uint8_t srgb)
{
    const double c = srgb / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

int byte_of(double linear)
{
    const double c = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
    return static_cast<int>(255.0 * c + 0.5);
}

/// Of black ink on white paper in the middle of the wall.
double mean_ink(const Pixels& picture)
{
    double ink = 0.0;
    int count = 0;
    for (int y = 24; y < 120; ++y)
        for (int x = 64; x < 128; ++x, ++count) ink += 1.0 - linear(picture.at(x, y)[1]);
    return ink / count;
}

constexpr int kLeft = 40, kRight = 152;  // columns of the wall

bool is_step(const Pixels& picture, int x, int y)
{
    for (int i = -1; i <= 1; ++i)
        if (std::abs(picture.at(x + i, y)[1] - picture.at(x, y)[1]) > 2) return true;
    return false;
}

}  // namespace

TEST(halftone_style, dots_have_the_ink_of_the_tone_and_come_again_in_their_distance)
{
    for (const double tone : {0.1, 0.4, 0.8}) {
        // Black reflects none of the light, so that the tone is the darkest.
        const Params params{{"darkness", tone},
                            {"material_tone", 1.0},
                            {"screen_deg", 0.0},
                            {"spacing_px", 8.0},
                            {"ink_colour", std::string("#000000")}};
        const Pixels picture = drawn("halftone", params, 0.0f);
        EXPECT_NEAR(mean_ink(picture), tone, 0.03);
        int lightest = 0, darkest = 255, unlike = 0;
        for (int y = 60; y < 80; ++y)
            for (int x = 80; x < 104; ++x) {
                lightest = std::max<int>(lightest, picture.at(x, y)[1]);
                darkest = std::min<int>(darkest, picture.at(x, y)[1]);
                unlike += std::abs(picture.at(x, y)[1] - picture.at(x + 8, y)[1]) > 4 ? 1 : 0;
                unlike += std::abs(picture.at(x, y)[1] - picture.at(x, y + 8)[1]) > 4 ? 1 : 0;
            }
        EXPECT_EQ(unlike, 0) << "dots stand in rows";
        EXPECT_GT(lightest - darkest, 100)
            << "dots, no gray, though the smallest are little wider than their soft edge";
    }
}

TEST(cartoon_style, a_step_that_is_one_pixel_wide_stands_where_the_hard_one_does)
{
    const Pixels hard = drawn("cartoon", {{"smoothing", std::string("none")}});
    const Pixels analytic = drawn("cartoon", {{"smoothing", std::string("analytic")}});
    int steps = 0;
    for (int y = 10; y < kSize.y - 10; ++y)
        for (int x = kLeft; x < kRight; ++x) {
            if (is_step(hard, x, y))
                ++steps;
            else
                EXPECT_NEAR(analytic.at(x, y)[1], hard.at(x, y)[1], 2) << x << ", " << y;
        }
    EXPECT_GT(steps, 0);
    EXPECT_EQ(steps % (2 * (kSize.y - 20)), 0) << "two pixels at a step, in every row";
}

TEST(cartoon_style, the_map_is_the_mean_of_a_pixel_and_its_diagonal_neighbours)
{
    const Pixels hard = drawn("cartoon", {{"smoothing", std::string("none")}});
    const Pixels map = drawn("cartoon", {{"smoothing", std::string("map")}});
    const Pixels analytic = drawn("cartoon", {{"smoothing", std::string("analytic")}});
    double map_from_analytic = 0.0, hard_from_analytic = 0.0;
    for (int y = 10; y < kSize.y - 10; ++y)
        for (int x = kLeft; x < kRight; ++x)
            for (int channel = 0; channel < 3; ++channel) {
                double sum = 4.0 * std::sqrt(linear(hard.at(x, y)[channel]));
                for (const int dy : {-1, 1})
                    for (const int dx : {-1, 1}) sum += std::sqrt(linear(hard.at(x + dx, y + dy)[channel]));
                EXPECT_NEAR(map.at(x, y)[channel], byte_of(sum * sum / 64.0), 3) << x << ", " << y;
                map_from_analytic += std::abs(map.at(x, y)[channel] - analytic.at(x, y)[channel]);
                hard_from_analytic += std::abs(hard.at(x, y)[channel] - analytic.at(x, y)[channel]);
            }
    EXPECT_GT(hard_from_analytic, 0.0);
    // The map is as wide at any slope, two pixels; the step is one.
    EXPECT_LT(map_from_analytic, 3.0 * hard_from_analytic);
}
