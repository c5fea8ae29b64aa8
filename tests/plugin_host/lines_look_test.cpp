// Styles whose lines come from the edge map: what that costs, and that the lines are where they belong.
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

constexpr glm::ivec2 kSize{256, 192};
constexpr int kMiddle = 128;

void add_quad(Scene& scene, const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v)
{
    MeshData mesh;
    for (const glm::vec3& point : {corner, corner + u, corner + u + v, corner + v}) {
        mesh.positions.push_back(point);
        mesh.normals.push_back(glm::normalize(glm::cross(u, v)));
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.has_own_normals = true;
    Object object{.node = 0, .mesh = static_cast<int>(scene.meshes.size()), .material = 0};
    for (const glm::vec3& point : mesh.positions) object.bounds_world.add(glm::dvec3(point));
    scene.bounds_world.add(object.bounds_world);
    scene.meshes.push_back(std::move(mesh));
    scene.objects.push_back(object);
}

/// A floor, and 6 m in front of the eye a sheet that stands a little askew before it and before nothing.
Scene floor_and_sheet()
{
    Scene scene;
    scene.materials.emplace_back();
    scene.nodes.push_back({.name = "all", .path = "all"});
    add_quad(scene, {-40, 0, 5}, {80, 0, 0}, {0, 0, -80});
    add_quad(scene, {-1, 1, -6}, {2, 0.07f, 0}, {-0.07f, 2, 0});
    return scene;
}

using Params = std::map<std::string, ParamValue>;

/// A style of a level: a plugin and its parameters.
StyleDesc style_of(const std::string& plugin, const Params& params)
{
    StyleDesc desc{.plugin = plugin};
    for (const auto& [name, value] : params) desc.params[name] = {value, "/styles/" + name};
    return desc;
}

struct Drawn {
    Pixels picture;
    FrameStats stats;
};

/// The floor in black ink, the sheet in a style.
Drawn drawn(const StyleDesc& sheet, const FrameOptions& options = {.samples = 4}, bool floor_too = false)
{
    const auto context = make_headless_context();
    const Scene scene = floor_and_sheet();
    Renderer renderer(*context, read_image);
    StyleSet set(test_registry(),
                 [&](const std::filesystem::path& folder) -> ProgramCache& { return renderer.program_cache(folder); });
    Level level;
    level.styles["sheet"] = sheet;
    level.styles["floor"] = style_of(
        "pen_and_ink",
        {{"paper_colour", std::string("#000000")}, {"tone", std::string("none")}, {"lines_from", std::string("none")}});
    set.set_level(level);
    SceneInput input;
    input.scene = &scene;
    input.objects.resize(2);
    input.objects[1].style = set.use("sheet", "");
    input.objects[0].style = floor_too ? input.objects[1].style : set.use("floor", "");
    input.styles = set.styles();
    input.image_passes = set.image_passes();
    renderer.load(std::move(input));
    Drawn result;
    result.stats = renderer.draw(camera_view({{0, 1.7, 0}, {0, 1.7, -10}, 60}, kSize, scene.bounds_world), options);
    result.picture = renderer.read_picture();
    EXPECT_TRUE(context->take_errors().empty());
    EXPECT_TRUE(renderer.remarks().empty()) << renderer.remarks().front();
    return result;
}

const Params kWhite{{"cool_colour", std::string("#ffffff")},
                    {"warm_colour", std::string("#ffffff")},
                    {"cool_from_material", 0.0},
                    {"warm_from_material", 0.0},
                    {"highlight", 0.0},
                    {"profile_colour", std::string("#000000")}};

/// Each traversal is depth, then colour, and nothing else.
const FrameOptions kPlain{.samples = 1, .skips_hidden = false};

Params with(Params params, const Params& more)
{
    for (const auto& [name, value] : more) params[name] = value;
    return params;
}

/// The last row of the sheet in the middle column, from above: where white ends.
int white_ends(const Pixels& picture)
{
    for (int y = kSize.y / 2; y < kSize.y; ++y)
        if (picture.at(kMiddle, y)[1] < 128) return y;
    return kSize.y;
}

}  // namespace

TEST(lines_look, technical_from_the_edge_map_is_two_traversals_and_one_full_screen_pass)
{
    const Params thin{{"profile_width_px", 1.0}, {"inner_width_px", 1.0}};
    const Drawn none = drawn(style_of("technical", with(thin, {{"lines_from", std::string("none")}})), kPlain, true);
    const Drawn lines = drawn(style_of("technical", thin), kPlain, true);
    EXPECT_EQ(none.stats.images_made, 0);
    EXPECT_EQ(lines.stats.images_made, 2) << "normals with depth, and the edge map";
    EXPECT_EQ(lines.stats.transient_targets, 2) << "one traversal, one full-screen pass";
    EXPECT_EQ(lines.stats.triangles, 2 * none.stats.triangles + 1)
        << "a second traversal, and one that fills the screen";
    EXPECT_EQ(lines.stats.edge_tables_built, 0);
    EXPECT_EQ(lines.stats.lines, 0u);
    const Drawn wide = drawn(style_of("technical", {{"profile_width_px", 3.0}}), kPlain, true);
    EXPECT_EQ(wide.stats.transient_targets, 5) << "wider lines take three full-screen passes more";
    EXPECT_EQ(wide.stats.triangles, 2 * none.stats.triangles + 4);
}

TEST(lines_look, id_outline_is_two_traversals_and_one_full_screen_pass_and_builds_no_adjacency)
{
    const Params thin{{"profile_width_px", 1.0}, {"inner_width_px", 1.0}};
    const Drawn none = drawn(style_of("id_outline", with(thin, {{"lines_from", std::string("none")}})), kPlain, true);
    const Drawn lines = drawn(style_of("id_outline", thin), kPlain, true);
    EXPECT_EQ(lines.stats.images_made, 3) << "ids with planes, the table of corners, and the edge map";
    EXPECT_EQ(lines.stats.transient_targets, 2) << "one traversal, one full-screen pass";
    EXPECT_EQ(lines.stats.triangles, 2 * none.stats.triangles + 1);
    EXPECT_EQ(lines.stats.adjacencies_built, 0);
    EXPECT_EQ(lines.stats.edge_tables_built, 0);
    EXPECT_EQ(lines.stats.lines, 0u);
}

TEST(lines_look, every_style_draws_lines_from_ids)
{
    const Params ids{{"lines_from", std::string("ids")}};
    const Params none{{"lines_from", std::string("none")}};
    for (const char* plugin :
         {"photoreal", "pen_and_ink", "hybrid", "technical", "cartoon", "halftone", "id_outline"}) {
        const Pixels with_lines = drawn(style_of(plugin, ids)).picture, without = drawn(style_of(plugin, none)).picture;
        int unlike = 0;
        for (std::size_t i = 0; i < without.bytes.size(); i += 3)
            unlike += std::abs(with_lines.bytes[i] - without.bytes[i]) > 40 ? 1 : 0;
        // The sheet's outline is about 4 x 55 px long.
        EXPECT_GT(unlike, 150) << plugin;
        EXPECT_LT(unlike, 900) << plugin;
    }
}

TEST(lines_look, the_border_of_an_object_has_no_bright_fringe_between_its_line_and_what_lies_behind)
{
    for (const std::string from : {"edge_map", "ids"}) {
        const Params wide = with(kWhite, {{"profile_width_px", 3.0}, {"lines_from", from}});
        const Pixels picture = drawn(style_of("technical", wide)).picture;
        // The border is askew: every column cuts it at another share of a pixel. From black floor to black line nothing
        // is white. Columns beside the upright borders lie in those lines' own soft sides.
        for (int x = 106; x < 150; ++x) {
            int y = kSize.y / 2;
            while (y < kSize.y && picture.at(x, y)[1] >= 128) ++y;
            ASSERT_LT(y, kSize.y - 10);
            for (int below = y + 1; below < y + 8; ++below)
                EXPECT_LT(picture.at(x, below)[1], 60) << from << ' ' << x << ", " << below;
        }
    }
}

TEST(lines_look, a_line_that_runs_askew_is_equally_wide_everywhere_without_saw_teeth)
{
    for (const std::string from : {"edge_map", "ids"}) {
        const Params wide = with(kWhite, {{"profile_width_px", 3.0}, {"lines_from", from}});
        const Pixels picture = drawn(style_of("technical", wide)).picture;
        // The upper border, before white paper, falls a pixel in 28. Ink across the line, of each column of the stair
        // that does not end at a corner; linear light.
        double least = 1e9, most = 0.0;
        for (int x = 114; x < 139; ++x) {
            double ink_px = 0.0;
            for (int y = 0; y < kSize.y / 2; ++y) ink_px += 1.0 - std::pow(picture.at(x, y)[1] / 255.0, 2.2);
            least = std::min(least, ink_px);
            most = std::max(most, ink_px);
        }
        EXPECT_NEAR(0.5 * (least + most), 3.0, 0.3) << from;
        // Four samples a pixel, so a quarter of one is as exact as its outer side can be.
        EXPECT_LT(most - least, 0.4) << from;
    }
}

TEST(lines_look, both_sources_draw_the_same_outline)
{
    const Params wide = with(kWhite, {{"profile_width_px", 4.0}});
    const int from_map = white_ends(drawn(style_of("technical", wide)).picture);
    const int from_model =
        white_ends(drawn(style_of("technical", with(wide, {{"lines_from", std::string("object")}}))).picture);
    const int without =
        white_ends(drawn(style_of("technical", with(wide, {{"lines_from", std::string("none")}}))).picture);
    EXPECT_NEAR(without - from_map, 4, 1) << "on the sheet's own side";
    EXPECT_NEAR(without - from_model, 2, 1) << "half of it on each";
}

TEST(lines_look, a_halo_lies_over_background_and_other_styles_and_belongs_to_the_styles_own_objects)
{
    const Params red = with(kWhite, {{"profile_colour", std::string("#ff0000")}, {"halo_px", 4.0}});
    const Pixels with_halo = drawn(style_of("technical", red)).picture;
    const Pixels without = drawn(style_of("technical", with(red, {{"halo_px", 0.0}}))).picture;
    const auto reds = [&](const Pixels& picture, int from_y, int to_y) {
        int count = 0;
        for (int y = from_y; y < to_y; ++y) {
            const std::uint8_t* rgb = picture.at(kMiddle, y);
            count += rgb[0] > 128 && rgb[1] < 100 ? 1 : 0;
        }
        return count;
    };
    // Above the sheet is the background, below it the floor of another style.
    EXPECT_NEAR(reds(with_halo, 0, kSize.y / 2) - reds(without, 0, kSize.y / 2), 4, 1);
    EXPECT_NEAR(reds(with_halo, kSize.y / 2, kSize.y) - reds(without, kSize.y / 2, kSize.y), 4, 1);
    // The floor ends before the background, and that edge is none of the sheet's.
    int beside = 0;
    for (int y = 0; y < kSize.y; ++y) beside += with_halo.at(8, y)[0] > 128 && with_halo.at(8, y)[1] < 100 ? 1 : 0;
    EXPECT_EQ(beside, 0);
}
