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

/// Shows what the edge map holds.
class EdgeShow final : public Style {
 public:
    explicit EdgeShow(std::string depth_operator) : key_{"edge_map", {{"operator", std::move(depth_operator)}}} {}
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

/// A floor of 80 m and, 6 m in front of the eye, a sheet of paper that stands 1 m above it.
Scene floor_and_sheet()
{
    Scene scene;
    MeshData mesh;
    add_quad(mesh, {-40, 0, 5}, {80, 0, 0}, {0, 0, -80});
    add_quad(mesh, {-1, 1, -6}, {2, 0, 0}, {0, 1.5f, 0});
    mesh.has_own_normals = true;
    scene.meshes.push_back(std::move(mesh));
    scene.materials.emplace_back();
    scene.nodes.push_back({.name = "all", .path = "all"});
    for (const glm::vec3& point : scene.meshes[0].positions) scene.bounds_world.add(glm::dvec3(point));
    scene.objects.push_back({.node = 0, .mesh = 0, .material = 0, .bounds_world = scene.bounds_world});
    return scene;
}

/// The picture: R and G are the edge map, 255 where there is no edge.
Pixels drawn(const std::string& depth_operator)
{
    const auto context = make_headless_context();
    const Scene scene = floor_and_sheet();
    Renderer renderer(*context);
    StyleSet set(test_registry(),
                 [&](const std::filesystem::path& f) -> ProgramCache& { return renderer.program_cache(f); });
    EdgeShow style(depth_operator);
    style.prepare(renderer.program_cache(HATCHWAY_SOURCE_DIR "/tests/plugin_host/shaders"));
    SceneInput input;
    input.scene = &scene;
    input.styles = {{"edge_show", &style}};
    input.objects.resize(1);
    input.objects[0].style = 0;
    input.image_passes = set.image_passes();
    renderer.load(std::move(input));
    const View view = camera_view({{0, 1.7, 0}, {0, 1.7, -10}, 60}, kSize, scene.bounds_world);
    renderer.draw(view, {.samples = 1});
    EXPECT_TRUE(context->take_errors().empty());
    return renderer.read_picture();
}

/// The darkest value of a channel in a row span.
int darkest(const Pixels& picture, int channel, glm::ivec2 from, glm::ivec2 to)
{
    int result = 255;
    for (int y = from.y; y <= to.y; ++y)
        for (int x = from.x; x <= to.x; ++x) result = std::min<int>(result, picture.at(x, y)[channel]);
    return result;
}

}  // namespace

TEST(edge_map, a_floor_at_a_grazing_angle_has_no_edges)
{
    for (const std::string depth_operator : {"diagonal", "c1"}) {
        const Pixels picture = drawn(depth_operator);
        for (const int channel : {0, 1})
            EXPECT_GE(darkest(picture, channel, {4, 104}, {60, kSize.y - 4}), 250)
                << depth_operator << ", channel " << channel;
    }
}

TEST(edge_map, the_border_of_a_sheet_before_a_floor_has_edges_of_depth_and_of_normals)
{
    for (const std::string depth_operator : {"diagonal", "c1"}) {
        const Pixels picture = drawn(depth_operator);
        // The lower border of the sheet: 0.7 m below the eye at 6 m.
        const int border = kSize.y / 2 + static_cast<int>(0.7 / 6.0 * kSize.y / (2.0 * 0.57735));
        EXPECT_LT(darkest(picture, 0, {128, border - 3}, {128, border + 3}), 160) << depth_operator;
        EXPECT_LT(darkest(picture, 1, {128, border - 3}, {128, border + 3}), 128) << depth_operator;
        EXPECT_GE(darkest(picture, 1, {118, kSize.y / 2 - 4}, {138, kSize.y / 2 + 4}), 250) << depth_operator;
    }
}
