// What docs/write_a_style.md promises of the images that styles share and of looking at one.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "hatchway/core/error.hpp"
#include "tests/render/style/scripted_style.hpp"

namespace hw::test {
namespace {

class shared_images : public RendererTest {
 protected:
    /// Whether a condition on the image `shown` holds, in a full-screen pass over all of it.
    bool holds(const std::string& name, const std::string& sampler, const std::string& condition)
    {
        return holds(ImageKey{name, {}}, sampler, condition);
    }
    bool holds(const ImageKey& key, const std::string& sampler, const std::string& condition)
    {
        const Program judging = shaders_.full_screen("#include \"full_screen.glsl\"\nuniform highp " + sampler +
                                                     " shown;\nvoid main() { hw_fragment = " + condition +
                                                     " ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0, 0.0, 0.0, 1.0); }\n");
        const Program show = shaders_.surface(
            "#include \"surface.glsl\"\nuniform sampler2D made;\nvoid main() { hw_surface();\n"
            "hw_output(texture(made, gl_FragCoord.xy / hw_size_px).rgb, 1.0); }\n");
        ScriptedStyle style;
        Image made;
        style.needed.images = {key};
        style.makes_images = [&](Pass& pass, Items) {
            const Image image = pass.image(key);
            format_ = image.format;
            made = pass.filter({}, judging, Uniforms().set("shown", image))[0];
        };
        style.draws_surfaces = [&](Pass& pass, Items items) {
            pass.surfaces(show, Uniforms().set("made", made), items);
        };
        load(style);
        return draw(view_from({0, 0, 4}, {0, 0, 0}), {.samples = 1}).at(160, 120)[1] == 255;
    }
    void add_box(double z, const Material& material)
    {
        add_object(scene_, box_mesh(glm::vec3(1.0f)), glm::translate(glm::dmat4(1.0), {0, 0, z}), material);
    }

    ShaderFolder shaders_{*renderer_};
    PixelFormat format_ = PixelFormat::rg8;
};

TEST_F(shared_images, normal_depth_has_unit_normals_and_metres_along_the_view_and_is_0_where_nothing_is)
{
    add_box(0, painted(glm::vec3(1.0f)));
    EXPECT_TRUE(
        holds("normal_depth", "sampler2D", "distance(texture(shown, vec2(0.5)), vec4(0.0, 0.0, 1.0, 3.5)) < 1e-3"));
    EXPECT_EQ(format_, PixelFormat::rgba32f);
    EXPECT_TRUE(holds("normal_depth", "sampler2D", "abs(texture(shown, vec2(0.55, 0.58)).w - 3.5) < 1e-3"))
        << "no distance from the eye";
    EXPECT_TRUE(holds("normal_depth", "sampler2D", "texture(shown, vec2(0.01)) == vec4(0.0)"));
}

TEST_F(shared_images, normal_depth_comes_in_halves_and_as_bytes_over_the_range_of_the_objects)
{
    add_box(0, painted(glm::vec3(1.0f)));
    add_box(-2, painted(glm::vec3(1.0f)));
    EXPECT_TRUE(holds({"normal_depth", {{"format", std::string("rgba16f")}}}, "sampler2D",
                      "distance(texture(shown, vec2(0.5)), vec4(0.0, 0.0, 1.0, 3.5)) < 2e-3"));
    EXPECT_EQ(format_, PixelFormat::rgba16f);
    const ImageKey bytes{"normal_depth", {{"format", std::string("rgba8")}}};
    // The boxes reach from 3.5 to 6.5 m.
    EXPECT_TRUE(holds(bytes, "sampler2D", "distance(texture(shown, vec2(0.5)), vec4(0.5, 0.5, 1.0, 0.0)) < 0.006"));
    EXPECT_EQ(format_, PixelFormat::rgba8);
    EXPECT_TRUE(holds(bytes, "sampler2D", "distance(texture(shown, vec2(0.01)), vec4(0.5, 0.5, 0.5, 1.0)) < 0.006"));
    EXPECT_THROW(holds({"normal_depth", {{"format", std::string("rgba4")}}}, "sampler2D", "true"), Error);
}

TEST_F(shared_images, normal_depth_holds_normals_of_triangles_or_interpolated_ones)
{
    add_object(scene_, sphere_mesh(1.0f, 8), glm::dmat4(1.0), painted(glm::vec3(1.0f)));
    const std::string same = "distance(texture(shown, vec2(0.5)).xyz, texture(shown, vec2(0.505)).xyz) < 1e-3";
    EXPECT_FALSE(holds("normal_depth", "sampler2D", same));
    EXPECT_TRUE(holds({"normal_depth", {{"normal", std::string("face")}}}, "sampler2D", same));
}

TEST_F(shared_images, normal_depth_holds_the_normals_of_normal_maps_where_it_is_asked_for_shading)
{
    // A normal map that leans to the right, as its red says: from (0, 0, 1) to (0.8, 0, 0.6).
    scene_.images = {Pixels{.width = 1, .height = 1, .channels = 4, .bytes = {230, 128, 204, 255}}};
    scene_.textures = {{.image = 0}};
    Material material = painted(glm::vec3(1.0f));
    material.normal_texture.texture = 0;
    MeshData square;
    square.positions = {{-2, -2, 0.5}, {2, -2, 0.5}, {2, 2, 0.5}, {-2, 2, 0.5}};
    square.normals.assign(4, {0, 0, 1});
    square.uv0 = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    square.indices = {0, 1, 2, 0, 2, 3};
    square.has_own_normals = true;
    add_object(scene_, square, glm::dmat4(1.0), material);
    const auto normal_is = [&](const char* normal, const std::string& expected) {
        return holds({"normal_depth", {{"normal", std::string(normal)}}}, "sampler2D",
                     "distance(texture(shown, vec2(0.5)).xyz, " + expected + ") < 0.02");
    };
    EXPECT_TRUE(normal_is("shading", "vec3(0.8, 0.0, 0.6)"));
    EXPECT_TRUE(normal_is("geometric", "vec3(0.0, 0.0, 1.0)"));
    EXPECT_TRUE(normal_is("face", "vec3(0.0, 0.0, 1.0)"));
}

TEST_F(shared_images, the_depth_range_is_of_all_objects_that_need_the_image_seen_or_not)
{
    for (const double x : {0.0, 50.0}) {  // the second stands beside the picture
        add_object(scene_, box_mesh(glm::vec3(1.0f)), glm::translate(glm::dmat4(1.0), {x, 0, -0.1 * x}),
                   painted(glm::vec3(1.0f)));
    }
    add_box(-40, painted(glm::vec3(1.0f)));
    ScriptedStyle needing, other;
    needing.needed.images = {{"normal_depth", {}}};
    DepthRange range;
    needing.makes_images = [&](Pass& pass, Items) { range = pass.depth_range({"normal_depth", {}}); };
    load({{"needing", &needing}, {"other", &other}}, {{.style = 0}, {.style = 0}, {.style = 1}});
    draw(view_from({0, 0, 4}, {0, 0, 0}));
    EXPECT_EQ(stats_.objects_visible, 2);
    EXPECT_NEAR(range.near_m, 3.5, 1e-3);
    EXPECT_NEAR(range.far_m, 9.5, 1e-3) << "of the one beside the picture, and not of the one that does not need it";
}

TEST_F(shared_images, normal_depth_leaves_out_what_lies_behind_all_that_need_it_and_keeps_what_may_hide_it)
{
    add_box(1.5, painted(glm::vec3(1.0f)));
    add_box(0, painted(glm::vec3(1.0f)));
    add_object(scene_, box_mesh({9.0f, 9.0f, 1.0f}), glm::translate(glm::dmat4(1.0), {0, 0, -5}),
               painted(glm::vec3(1.0f)));
    ScriptedStyle needing, other;
    needing.needed.images = {{"normal_depth", {}}};
    std::string condition;
    Image judged;
    needing.makes_images = [&](Pass& pass, Items) {
        const Program judge = shaders_.full_screen(
            "#include \"full_screen.glsl\"\nuniform sampler2D shown;\nvoid main() { hw_fragment = vec4(" + condition +
            " ? 1.0 : 0.0); }\n");
        judged = pass.filter({}, judge, Uniforms().set("shown", pass.image({"normal_depth", {}})))[0];
    };
    const Program show = shaders_.full_screen(
        "#include \"full_screen.glsl\"\nuniform sampler2D made;\nvoid main() { hw_fragment = texture(made, "
        "hw_v_uv); }\n");
    needing.draws_lines = [&](Pass& pass, Items) { pass.cover(show, Uniforms().set("made", judged)); };
    load({{"needing", &needing}, {"other", &other}}, {{.style = 1}, {.style = 0}, {.style = 1}});
    for (const char* holds :
         {"abs(texture(shown, vec2(0.5)).w - 2.0) < 1e-3", "texture(shown, vec2(0.25, 0.5)).w == 0.0"}) {
        condition = holds;
        EXPECT_EQ(draw(view_from({0, 0, 4}, {0, 0, 0})).at(160, 120)[1], 255) << holds;
    }
}

TEST_F(shared_images, a_full_screen_pass_is_laid_over_the_picture_by_its_alpha_where_lines_are_drawn)
{
    add_box(0, painted(glm::vec3(1.0f)));
    const Program half_red = shaders_.full_screen(
        "#include \"full_screen.glsl\"\nvoid main() { hw_fragment = vec4(1.0, 0.0, 0.0, hw_v_uv.x < 0.5 ? 1.0 : 0.0); "
        "}\n");
    ScriptedStyle style;
    input_.background_srgb = glm::vec3(0.0f, 1.0f, 0.0f);
    style.draws_lines = [&](Pass& pass, Items) { pass.cover(half_red, {}); };
    load(style);
    for (const int samples : {1, 4}) {
        const Pixels picture = draw(view_from({0, 0, 4}, {0, 0, 0}), {.samples = samples});
        EXPECT_EQ(picture.at(20, 120)[0], 255);
        EXPECT_EQ(picture.at(20, 120)[1], 0);
        EXPECT_EQ(picture.at(300, 120)[0], 0);
        EXPECT_EQ(picture.at(300, 120)[1], 255);
    }
    style.draws_lines = {};
    style.draws_surfaces = style.makes_images = [&](Pass& pass, Items) { pass.cover(half_red, {}); };
    EXPECT_EQ(draw(view_from({0, 0, 4}, {0, 0, 0})).at(20, 120)[1], 255) << "nowhere else";
}

TEST_F(shared_images, ids_are_whole_numbers_from_1_on_of_what_is_opaque_or_masked)
{
    Material glass = painted(glm::vec3(1.0f)), hole = painted(glm::vec3(1.0f));
    glass.alpha_mode = AlphaMode::blend;
    hole.alpha_mode = AlphaMode::mask;
    hole.base_colour.a = 0.1f;
    add_box(1.2, glass);
    add_box(1.5, hole);
    add_box(0, painted(glm::vec3(1.0f)));
    EXPECT_TRUE(holds("object_ids", "usampler2D", "texelFetch(shown, ivec2(160, 120), 0).r == 3u"));
    EXPECT_EQ(format_, PixelFormat::r32ui);
    EXPECT_TRUE(holds("object_ids", "usampler2D", "texelFetch(shown, ivec2(2), 0).r == 0u"));
    EXPECT_TRUE(holds("triangle_ids", "usampler2D", "texelFetch(shown, ivec2(160, 120), 0).r > 24u"));
    EXPECT_EQ(format_, PixelFormat::r32ui);
}

TEST_F(shared_images, are_looked_at_with_negative_values_as_positive_and_neighbouring_numbers_apart)
{
    for (const double z : {-0.6, 0.6}) add_box(z, painted(glm::vec3(1.0f)));
    TestStyle style(glm::vec3(0.5f));
    load(style);
    FrameOptions options{.samples = 1};
    options.shown_image = {"normal_depth", {}};
    const View from_the_left = view_from({-4, 0, 0}, {0, 0, 0});
    EXPECT_EQ(draw(from_the_left, options).at(150, 120)[0], 255) << "its normal is -x";
    options.shown_image = {"object_ids", {}};
    const Pixels ids = draw(from_the_left, options);
    const auto apart = [&](int channel) { return std::abs(ids.at(140, 120)[channel] - ids.at(180, 120)[channel]); };
    EXPECT_GT(apart(0) + apart(1) + apart(2), 60);
}

}  // namespace
}  // namespace hw::test
