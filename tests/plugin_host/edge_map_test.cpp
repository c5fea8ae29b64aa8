// The edge map as a style sees it: drawn by the renderer, sampled at the fragment's own pixel.
#include <gtest/gtest.h>

#include "hatchway/gl/context.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/plugin_host/style_set.hpp"
#include "hatchway/render/renderer.hpp"
#include "hatchway/render/view/camera_view.hpp"
#include "tests/plugin_host/plugin_tests.hpp"

using namespace hw;
using namespace hw::test;

namespace {

constexpr glm::ivec2 kSize{256, 192};

using EdgeParams = std::map<std::string, ParamValue>;

/// Shows what the edge map holds.
class EdgeShow final : public Style {
 public:
    explicit EdgeShow(EdgeParams params) : key_{"edge_map", std::move(params)} {}
    Needs needs() const override
    {
        Needs needs;
        needs.images.push_back(key_);
        return needs;
    }
    void prepare(ProgramCache& programs) override { program_ = programs.surface("edge_show.frag"); }
    void surfaces(Pass& pass, Items items) override
    {
        Uniforms uniforms;
        uniforms.set("edges", pass.image(key_));
        pass.surfaces(program_, uniforms, items);
    }

 private:
    ImageKey key_;
    Program program_;
};

/// Adds a rectangle, counter-clockwise, with its own normal.
void add_quad(MeshData& mesh, const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec3& point : {corner, corner + u, corner + u + v, corner + v}) {
        mesh.positions.push_back(point);
        mesh.normals.push_back(glm::normalize(glm::cross(u, v)));
    }
    for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + i);
}

Scene scene_of(MeshData mesh)
{
    Scene scene;
    mesh.has_own_normals = true;
    scene.meshes.push_back(std::move(mesh));
    scene.materials.emplace_back();
    scene.nodes.push_back({.name = "all", .path = "all"});
    for (const glm::vec3& point : scene.meshes[0].positions) scene.bounds_world.add(glm::dvec3(point));
    scene.objects.push_back({.node = 0, .mesh = 0, .material = 0, .bounds_world = scene.bounds_world});
    return scene;
}

/// The picture: R and G are the edge map, 255 where there is no edge.
Pixels drawn(const EdgeParams& params, float px_scale, const Scene& scene,
             const CameraPlace& camera = {{0, 1.7, 0}, {0, 1.7, -10}, 60})
{
    const auto context = make_headless_context();
    Renderer renderer(*context);
    StyleSet set(test_registry(),
                 [&](const std::filesystem::path& f) -> ProgramCache& { return renderer.program_cache(f); });
    EdgeShow style(params);
    style.prepare(renderer.program_cache(HATCHWAY_SOURCE_DIR "/tests/plugin_host/shaders"));
    SceneInput input;
    input.scene = &scene;
    input.styles = {{"edge_show", &style}};
    input.objects.resize(1);
    input.objects[0].style = 0;
    input.image_passes = set.image_passes();
    renderer.load(std::move(input));
    const FrameStats stats = renderer.draw(camera_view(camera, kSize, scene.bounds_world, px_scale), {.samples = 1});
    EXPECT_TRUE(context->take_errors().empty());
    EXPECT_EQ(stats.adjacencies_built, 0) << "images need no topology";
    return renderer.read_picture();
}

/// A floor of 80 m and, 6 m in front of the eye, a sheet of paper that stands 1 m above it.
Pixels drawn(const EdgeParams& params = {}, float px_scale = 1.0f)
{
    MeshData mesh;
    add_quad(mesh, {-40, 0, 5}, {80, 0, 0}, {0, 0, -80});
    add_quad(mesh, {-1, 1, -6}, {2, 0, 0}, {0, 1.5f, 0});
    return drawn(params, px_scale, scene_of(std::move(mesh)));
}

/// The darkest value of a channel in a row span.
int darkest(const Pixels& picture, int channel, glm::ivec2 from, glm::ivec2 to)
{
    int result = 255;
    for (int y = from.y; y <= to.y; ++y)
        for (int x = from.x; x <= to.x; ++x) result = std::min<int>(result, picture.at(x, y)[channel]);
    return result;
}

/// The last row of the sheet: its border is 0.7 m below the eye at 6 m.
const int kBorder = kSize.y / 2 + static_cast<int>(0.7 / 6.0 * kSize.y / (2.0 * 0.57735)) - 1;
constexpr int kMiddle = 128;  // a column of the sheet

/// Rows of the profile's ink (linear bytes arrive as sRGB: 0.78 and more of it) around the lower border in the middle
/// column: how many above it and below, and whether one without ink lies between them.
struct Span {
    int above = 0, below = 0;
    bool has_gap = false;
};
Span ink_at_border(const Pixels& picture)
{
    Span span;
    const auto is_ink = [&](int y) { return picture.at(kMiddle, y)[1] < 128; };
    for (int y = kBorder - 16; y <= kBorder + 16; ++y) (y <= kBorder ? span.above : span.below) += is_ink(y) ? 1 : 0;
    for (int y = kBorder - span.above + 1; y <= kBorder + span.below; ++y) span.has_gap |= !is_ink(y);
    return span;
}

}  // namespace

TEST(edge_map, a_floor_at_a_grazing_angle_has_no_edges)
{
    const Pixels picture = drawn();
    for (const int channel : {0, 1})
        EXPECT_EQ(darkest(picture, channel, {4, 104}, {60, kSize.y - 1}), 255) << "channel " << channel;
}

TEST(edge_map, the_border_of_a_sheet_before_a_floor_is_a_profile_edge_on_the_sheet_alone)
{
    const Pixels picture = drawn();
    const Span ink = ink_at_border(picture);
    EXPECT_EQ(ink.above, 1);
    EXPECT_EQ(ink.below, 0);
    EXPECT_EQ(darkest(picture, 0, {kMiddle, kBorder - 3}, {kMiddle, kBorder + 3}), 255) << "no inner edge";
    EXPECT_EQ(darkest(picture, 1, {118, kSize.y / 2 - 4}, {138, kSize.y / 2 + 4}), 255) << "nothing on the sheet";
}

TEST(edge_map, the_operators_of_2003_mark_both_sides_of_the_border)
{
    for (const std::string format : {"rgba8", "rgba32f"})
        for (const std::string name : {"diagonal", "c1", "c1_three_passes"}) {
            const Pixels picture =
                drawn({{"operator", name}, {"format", format}, {"normal", std::string("geometric")}});
            EXPECT_EQ(darkest(picture, 1, {118, kSize.y / 2 - 4}, {138, kSize.y / 2 + 4}), 255)
                << "on the sheet, " << name;
            EXPECT_LT(darkest(picture, 0, {kMiddle, kBorder}, {kMiddle, kBorder}), 200) << name << ' ' << format;
            EXPECT_LT(darkest(picture, 0, {kMiddle, kBorder + 1}, {kMiddle, kBorder + 1}), 200)
                << name << ' ' << format;
        }
}

TEST(edge_map, is_as_wide_as_asked_without_gaps_on_the_nearer_side)
{
    for (int width = 1; width <= 8; ++width)
        for (const float px_scale : {1.0f, 2.0f}) {
            const Span ink = ink_at_border(drawn({{"width_px", static_cast<double>(width)}}, px_scale));
            EXPECT_EQ(ink.above, std::min(static_cast<int>(width * px_scale), 17)) << width << " at " << px_scale;
            EXPECT_EQ(ink.below, 0) << width;
            EXPECT_FALSE(ink.has_gap) << width;
        }
}

TEST(edge_map, of_ids_is_as_wide_as_asked_without_gaps_on_the_nearer_side)
{
    for (const std::string storage : {"vertices", "lists"})
        for (int width = 1; width <= 8; ++width)
            for (const float px_scale : {1.0f, 2.0f}) {
                const Span ink = ink_at_border(drawn(
                    {{"operator", std::string("ids")}, {"storage", storage}, {"width_px", static_cast<double>(width)}},
                    px_scale));
                EXPECT_EQ(ink.above, std::min(static_cast<int>(width * px_scale), 17)) << width << " at " << px_scale;
                EXPECT_EQ(ink.below, 0) << width;
                EXPECT_FALSE(ink.has_gap) << width;
            }
}

TEST(edge_map, of_ids_has_a_halo_too_and_tells_borders_in_all_of_it)
{
    for (const double width : {1.0, 3.0}) {
        const Pixels picture = drawn({{"operator", std::string("ids")}, {"halo_px", 3.0}, {"width_px", width}});
        EXPECT_EQ(ink_at_border(picture).below, 3);
        for (int y = kBorder - 12; y < kBorder + 12; ++y)
            EXPECT_EQ(picture.at(kMiddle, y)[1], picture.at(kMiddle, y)[2]) << "floor and sheet are one object";
        // The sheet ends 0.8 m above the eye, before nothing: 22 rows above the middle.
        EXPECT_LT(darkest(picture, 1, {kMiddle, 72}, {kMiddle, 76}), 128);
        EXPECT_EQ(darkest(picture, 2, {kMiddle, 60}, {kMiddle, 80}), 255) << "an outline is no border";
    }
}

TEST(edge_map, of_ids_2011_marks_both_sides_and_grows_to_both)
{
    for (const int width : {1, 2, 4, 8}) {
        const Span ink =
            ink_at_border(drawn({{"operator", std::string("ids_2011")}, {"width_px", static_cast<double>(width)}}));
        EXPECT_EQ(ink.above, std::max(1, width / 2)) << width;
        EXPECT_EQ(ink.below, std::max(1, width / 2)) << width;
        EXPECT_FALSE(ink.has_gap);
    }
}

namespace {

/// Of the columns from 78 to 178, the share in which some pixel of the rows is an edge: profile or inner.
double share_of_columns(const Pixels& picture, int from_y, int to_y)
{
    int found = 0;
    for (int x = 78; x < 178; ++x)
        found +=
            std::min(darkest(picture, 0, {x, from_y}, {x, to_y}), darkest(picture, 1, {x, from_y}, {x, to_y})) < 200;
    return found / 100.0;
}

/// Looks down at the middle of the table y = 0 from 1 m, rows along z: 1 m is 166 px.
const CameraPlace kFromAbove{{0, 1, 0.0001}, {0, 0, 0}, 60};

}  // namespace

TEST(edge_map, of_ids_outlines_paper_on_a_desk_where_depth_and_normals_know_nothing)
{
    MeshData mesh;
    add_quad(mesh, {-2, 0, 2}, {4, 0, 0}, {0, 0, -4});
    add_quad(mesh, {-0.4f, 1e-4f, 0.2f}, {0.8f, 0, 0}, {0, 0, -0.4f});
    const Scene scene = scene_of(std::move(mesh));
    for (const std::string name : {"ids", "ids_2011", "second"}) {
        const Pixels picture = drawn({{"operator", name}}, 1.0f, scene, kFromAbove);
        const double wanted = name == "second" ? 0.0 : 1.0;
        EXPECT_EQ(share_of_columns(picture, 96 + 31, 96 + 35), wanted) << name << ", near edge";
        EXPECT_EQ(share_of_columns(picture, 96 - 36, 96 - 31), wanted) << name << ", far edge";
        EXPECT_EQ(share_of_columns(picture, 96 - 28, 96 + 28), 0.0) << name << ", on the sheet";
    }
}

TEST(edge_map, of_ids_shows_the_edge_of_folded_paper_that_lies_on_the_rest)
{
    MeshData
        mesh;  // welded at the fold; the flap has two rows, so that the one at its free edge has no corner of the rest
    add_quad(mesh, {-0.4f, 0, 0.3f}, {0.8f, 0, 0}, {0, 0, -0.6f});
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const float z : {0.2f, 0.0f})
        for (const float x : {0.4f, -0.4f}) {
            mesh.positions.emplace_back(x, 1e-4f, z);
            mesh.normals.emplace_back(0, 1, 0);
        }
    for (const std::uint32_t i :
         {0u, 1u, first, 0u, first, first + 1, first + 1, first, first + 2, first + 1, first + 2, first + 3})
        mesh.indices.push_back(i);
    const Scene scene = scene_of(std::move(mesh));
    EXPECT_EQ(share_of_columns(drawn({}, 1.0f, scene, kFromAbove), 92, 99), 0.0);
    for (const std::string name : {"ids", "ids_2011"}) {
        const Pixels picture = drawn({{"operator", name}}, 1.0f, scene, kFromAbove);
        EXPECT_EQ(share_of_columns(picture, 92, 99), 1.0) << name;
    }
}

TEST(edge_map, of_ids_shows_flaps_that_lie_side_by_side_in_one_plane)
{
    MeshData mesh;
    add_quad(mesh, {-0.4f, 0, 0.3f}, {0.8f, 0, 0}, {0, 0, -0.3f});
    add_quad(mesh, {-0.5f, 0, 0}, {1.0f, 0, 0}, {0, 0, -0.3f});
    const Scene scene = scene_of(std::move(mesh));
    for (const std::string name : {"ids", "ids_2011"})
        EXPECT_EQ(share_of_columns(drawn({{"operator", name}}, 1.0f, scene, kFromAbove), 93, 98), 1.0) << name;
    EXPECT_EQ(share_of_columns(drawn({}, 1.0f, scene, kFromAbove), 93, 98), 0.0) << "second";
}

TEST(edge_map, of_2003_grows_to_both_sides)
{
    const Pixels wide = drawn({{"operator", std::string("diagonal")}, {"inner_width_px", 8.0}});
    EXPECT_LT(darkest(wide, 0, {kMiddle, kBorder - 3}, {kMiddle, kBorder - 3}), 200);
    EXPECT_LT(darkest(wide, 0, {kMiddle, kBorder + 4}, {kMiddle, kBorder + 4}), 200);
    EXPECT_EQ(darkest(wide, 0, {kMiddle, kBorder - 8}, {kMiddle, kBorder - 8}), 255);
}

TEST(edge_map, a_halo_reaches_beyond_the_object_as_far_as_asked)
{
    for (int halo = 0; halo <= 8; halo += 2) {
        const Span ink = ink_at_border(drawn({{"halo_px", static_cast<double>(halo)}}));
        EXPECT_EQ(ink.below, halo);
        EXPECT_EQ(ink.above, 1);
        EXPECT_FALSE(ink.has_gap);
    }
}
