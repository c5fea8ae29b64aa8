// What docs/write_a_style.md promises of the calls of a style: when they come, with which items, and what these tell.
#include <gmock/gmock.h>

#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/style/scripted_style.hpp"

namespace hw::test {
namespace {

using testing::ElementsAre;

constexpr glm::dmat4 kHere(1.0);

glm::dmat4 at(double x, double y, double z)
{
    return glm::translate(kHere, glm::dvec3(x, y, z));
}

Material glass()
{
    Material material = painted(glm::vec3(1.0f));
    material.alpha_mode = AlphaMode::blend;
    material.base_colour.a = 0.5f;
    return material;
}

/// "surfaces opaque 0 2": the call, the layer and the objects.
std::string told(const std::string& call, const Pass& pass, Items items)
{
    std::string text = call + (pass.layer() == Layer::opaque ? " opaque" : " blended");
    for (const DrawItem& item : items) text += ' ' + std::to_string(item.object());
    return text;
}

class calls : public RendererTest {
 protected:
    void record(ScriptedStyle& style, std::vector<std::string>& log)
    {
        style.makes_images = [&](Pass& pass, Items items) { log.push_back(told("images", pass, items)); };
        style.draws_surfaces = [&](Pass& pass, Items items) { log.push_back(told("surfaces", pass, items)); };
        style.draws_lines = [&](Pass& pass, Items items) { log.push_back(told("lines", pass, items)); };
    }
};

TEST_F(calls, come_in_order_and_again_for_blended_faces_from_back_to_front)
{
    add_object(scene_, box_mesh(glm::vec3(1.0f)), at(0, 0, -3), painted(glm::vec3(1.0f)));
    add_object(scene_, box_mesh(glm::vec3(1.0f)), at(0, 0, 0), glass());
    add_object(scene_, box_mesh(glm::vec3(1.0f)), at(0, 0, -1.5), glass());
    add_object(scene_, box_mesh(glm::vec3(1.0f)), at(2, 0, -5), painted(glm::vec3(1.0f)));
    std::vector<std::string> log;
    ScriptedStyle style;
    record(style, log);
    load(style);
    draw(view_from({0, 0, 4}, {0, 0, 0}));
    EXPECT_THAT(log, ElementsAre("images opaque 0 3 2 1", "surfaces opaque 0 3", "lines opaque 0 3",
                                 "surfaces blended 2 1", "lines blended 2 1"));
}

TEST_F(calls, leave_out_styles_of_which_nothing_is_seen)
{
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, painted(glm::vec3(1.0f)));
    add_object(scene_, box_mesh(glm::vec3(1.0f)), at(0, 0, 20), painted(glm::vec3(1.0f)));
    std::vector<std::string> seen_log, unseen_log;
    ScriptedStyle seen, unseen;
    record(seen, seen_log);
    record(unseen, unseen_log);
    load({{"seen", &seen}, {"unseen", &unseen}}, {{.style = 0}, {.style = 1}});
    draw(view_from({0, 0, 4}, {0, 0, 0}));
    EXPECT_THAT(seen_log, ElementsAre("images opaque 0", "surfaces opaque 0", "lines opaque 0"));
    EXPECT_THAT(unseen_log, testing::IsEmpty());
}

TEST_F(calls, for_faces_come_once_for_objects_of_which_the_style_is_the_first_and_once_where_it_lies_over_another)
{
    for (const double x : {-1.0, 1.0}) add_object(scene_, box_mesh(glm::vec3(1.0f)), at(x, 0, 0), Material{});
    std::vector<std::string> log;
    ScriptedStyle style, other;
    record(style, log);
    load({{"style", &style}, {"other", &other}}, {{.style = 0}, {.style = 1, .over = 0}});
    draw(view_from({0, 0, 4}, {0, 0, 0}));
    EXPECT_THAT(log, ElementsAre("images opaque 0 1", "surfaces opaque 0", "surfaces opaque 1", "lines opaque 0 1"));
}

TEST_F(calls, tell_the_view)
{
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, Material{});
    ScriptedStyle style;
    style.needed.clock = true;
    View told_view;
    style.draws_surfaces = [&](Pass& pass, Items) { told_view = pass.view(); };
    load(style);
    View view = camera_view({{1, 2, 4}, {0, 0, 0}, 60.0}, {64, 48}, scene_.bounds_world, 2.0f);
    view.time_s = 3.25;
    draw(view);
    EXPECT_EQ(told_view.size_px, glm::ivec2(64, 48));
    EXPECT_EQ(told_view.px_scale, 2.0f);
    EXPECT_EQ(told_view.time_s, 3.25);
    EXPECT_EQ(told_view.eye_world, glm::dvec3(1, 2, 4));
    EXPECT_EQ(told_view.view_from_world, view.view_from_world);
    EXPECT_EQ(told_view.clip_from_view, view.clip_from_view);
}

TEST_F(calls, have_items_that_tell_their_object)
{
    MeshData sheet = floor_mesh(2.0f);
    sheet.uv0.assign(4, glm::vec2(0.0f));
    sheet.colours.assign(4, glm::vec4(1.0f));
    Material material;
    material.base_colour = {0.1f, 0.2f, 0.3f, 0.9f};
    material.metallic = 0.25f;
    material.roughness = 0.75f;
    material.emissive = {1, 2, 3};
    material.alpha_mode = AlphaMode::mask;
    material.is_double_sided = true;
    add_object(scene_, box_mesh(glm::vec3(1.0f)), at(0, 9, 0), Material{});
    add_object(scene_, sheet, at(0, 1, 0), material);
    ScriptedStyle style;
    std::vector<DrawItem> told_items;
    style.draws_surfaces = [&](Pass&, Items items) { told_items.assign(items.begin(), items.end()); };
    load({{"only", &style}}, {{.style = 0}, {.style = 0, .certainty = 0.25f}});
    draw(view_from({0, 2, 2}, {0, 1, 0}));
    ASSERT_EQ(told_items.size(), 1u) << "of what is seen";
    const DrawItem& item = told_items[0];
    EXPECT_EQ(item.object(), 1u);
    EXPECT_EQ(item.certainty(), 0.25f);
    EXPECT_EQ(item.mesh().vertices, 4u);
    EXPECT_EQ(item.mesh().triangles, 2u);
    EXPECT_TRUE(item.mesh().has_uv && item.mesh().has_colours);
    EXPECT_EQ(item.material().base_colour, material.base_colour);
    EXPECT_EQ(item.material().emissive, material.emissive);
    EXPECT_EQ(item.material().metallic, 0.25f);
    EXPECT_EQ(item.material().roughness, 0.75f);
    EXPECT_TRUE(item.material().is_masked && item.material().is_double_sided);
    EXPECT_FALSE(item.material().is_blended || item.material().is_unlit || item.material().has_base_colour_map);
    EXPECT_EQ(item.world_from_object()[3], glm::vec4(0, 1, 0, 1));
    EXPECT_EQ(item.bounds_world().min, glm::dvec3(-1, 1, -1));
}

TEST_F(calls, know_the_opaque_and_masked_objects_of_all_styles)
{
    Material mask = painted(glm::vec3(1.0f));
    mask.alpha_mode = AlphaMode::mask;
    add_object(scene_, box_mesh(glm::vec3(1.0f)), at(0, 0, 0), painted(glm::vec3(1.0f)));
    add_object(scene_, box_mesh(glm::vec3(1.0f)), at(0, 0, -2), mask);
    add_object(scene_, box_mesh(glm::vec3(1.0f)), at(0, 0, -4), glass());
    add_object(scene_, box_mesh(glm::vec3(1.0f)), at(0, 0, 9), painted(glm::vec3(1.0f)));
    ScriptedStyle style, other;
    std::string log;
    style.makes_images = [&](Pass& pass, Items) { log = told("all", pass, pass.opaque_scene()); };
    load({{"style", &style}, {"other", &other}}, {{.style = 1}, {.style = 1}, {.style = 0}, {.style = 1}});
    draw(view_from({0, 0, 4}, {0, 0, 0}));
    EXPECT_EQ(log, "all opaque 0 1") << "near before far; neither glass nor what is behind the eye";
}

TEST_F(calls, read_what_images_made_in_the_same_frame_in_lines_too)
{
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, painted(glm::vec3(1.0f)));
    ShaderFolder shaders(*renderer_);
    const Program red =
        shaders.full_screen("#include \"full_screen.glsl\"\nvoid main() { hw_fragment = vec4(1.0, 0.0, 0.0, 1.0); }\n");
    const Program pen = shaders.line(
        "#include \"line_pen.glsl\"\nuniform sampler2D made;\nvoid main() { HwLine line = hw_line();\n"
        "hw_output(texture(made, vec2(0.5)).rgb, line.coverage); }\n");
    ScriptedStyle style;
    Image made;
    style.needed.edges = EdgeNeed{};
    style.makes_images = [&](Pass& pass, Items) { made = pass.filter({}, red, {})[0]; };
    style.draws_lines = [&](Pass& pass, Items items) {
        LineLook look;
        look.all({.width_px = 6.0f});
        pass.lines(pen, Uniforms().set("made", made), look, items);
    };
    load(style);
    const Pixels pixels = draw(view_from({0, 0, 4}, {0, 0, 0}));
    int red_pixels = 0;
    for (int x = 0; x < 320; ++x) red_pixels += pixels.at(x, 120)[0] == 255 && pixels.at(x, 120)[1] == 0 ? 1 : 0;
    EXPECT_GT(red_pixels, 6) << "two lines cross the middle";
    EXPECT_EQ(count_dark(pixels), 0);
}

TEST_F(calls, draw_into_the_picture_again_after_a_pass_into_a_target)
{
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, painted(glm::vec3(1.0f)));
    ShaderFolder shaders(*renderer_);
    const Program faces =
        shaders.surface("#include \"surface.glsl\"\nvoid main() { hw_surface(); hw_output(vec3(1.0), 1.0); }\n");
    const Program filter =
        shaders.full_screen("#include \"full_screen.glsl\"\nvoid main() { hw_fragment = vec4(1.0); }\n");
    ScriptedStyle style;
    style.needed.edges = EdgeNeed{};
    for (const bool is_render : {true, false}) {
        style.draws_lines = [&](Pass& pass, Items items) {
            is_render ? pass.render({}, faces, {}, items) : pass.filter({}, filter, {});
            LineLook look;
            look.all({.width_px = 6.0f});
            pass.lines(look, items);
        };
        load(style);
        EXPECT_GT(count_dark(draw(view_from({0, 0, 4}, {0, 0, 0}))), 100) << is_render;
    }
}

TEST_F(calls, of_a_style_compile_each_program_once)
{
    ShaderFolder shaders(*renderer_);
    shaders.surface("#include \"surface.glsl\"\nvoid main() { hw_surface(); hw_output(vec3(1.0), 1.0); }\n");
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, Material{});
    ScriptedStyle style;
    load(style);
    draw(view_from({0, 0, 4}, {0, 0, 0}));
    const int before = stats_.programs_compiled;
    const Program first = shaders.cache().surface("shader_0.frag");
    EXPECT_EQ(shaders.cache().surface("shader_0.frag").id, first.id);
    EXPECT_NE(shaders.cache().surface("shader_0.frag", "#define OTHER 1\n").id, first.id);
    draw(view_from({0, 0, 4}, {0, 0, 0}));
    EXPECT_EQ(stats_.programs_compiled, before + 1);
}

}  // namespace
}  // namespace hw::test
