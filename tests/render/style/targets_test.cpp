// What docs/write_a_style.md promises of targets, images and uniforms.
#include <gmock/gmock.h>

#include <cmath>

#include "hatchway/core/log.hpp"
#include "tests/render/style/scripted_style.hpp"

namespace hw::test {
namespace {

const glm::ivec3 kGreen(0, 255, 0);

/// A full-screen program that shows green where `condition` holds, else red.
std::string judge(const std::string& declarations, const std::string& condition)
{
    return "#include \"full_screen.glsl\"\n" + declarations + "\nvoid main() { hw_fragment = " + condition +
           " ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0, 0.0, 0.0, 1.0); }\n";
}

/// A full-screen program that fills one output.
std::string writer(const std::string& value)
{
    return "#include \"full_screen.glsl\"\nvoid main() { hw_fragment = " + value + "; }\n";
}

std::string whole_number_writer(const std::string& type, const std::string& value)
{
    return "#define HW_OWN_OUTPUTS\n#include \"full_screen.glsl\"\nlayout(location = 0) out " + type +
           " written;\nvoid main() { written = " + value + "; }\n";
}

class targets : public RendererTest {
 protected:
    targets()
    {
        add_object(scene_, box_mesh(glm::vec3(1.0f)), glm::dmat4(1.0), painted(glm::vec3(1.0f)));
        show_ = shaders_.surface(
            "#include \"surface.glsl\"\nuniform sampler2D shown;\nvoid main() { HwSurface s = hw_surface();\n"
            "hw_output(texture(shown, gl_FragCoord.xy / hw_size_px).rgb, hw_presence(s)); }\n");
    }

    /// The middle of the picture when the box shows what `make` gives.
    glm::ivec3 shown(const std::function<Image(Pass&, Items)>& make, glm::ivec2 size_px = {320, 240})
    {
        ScriptedStyle style;
        Image image;
        style.makes_images = [&](Pass& pass, Items items) { image = make(pass, items); };
        style.draws_surfaces = [&](Pass& pass, Items items) {
            pass.surfaces(show_, Uniforms().set("shown", image), items);
        };
        load(style);
        const Pixels pixels = draw(view_from({0, 0, 4}, {0, 0, 0}, size_px), {.samples = 1});
        const std::uint8_t* at = pixels.at(size_px.x / 2, size_px.y / 2);
        return {at[0], at[1], at[2]};
    }

    /// Fills a target by `writer` and asks `judge` about it.
    glm::ivec3 judged(const TargetDesc& target, Program written, Program judging, const Uniforms& uniforms = {})
    {
        return shown([&](Pass& pass, Items) {
            Uniforms all = uniforms;
            return pass.filter({}, judging, all.set("source", pass.filter(target, written, {})[0]))[0];
        });
    }

    ShaderFolder shaders_{*renderer_};
    Program show_;
};

TEST_F(targets, of_each_format_keep_what_it_can_hold)
{
    struct Case {
        PixelFormat format;
        glm::vec4 kept;
    };
    const Program written = shaders_.full_screen(writer("vec4(0.25, 0.75, 1000.5, -3.0)"));
    const Program judging =
        shaders_.full_screen(judge("uniform sampler2D source; uniform vec4 kept;",
                                   "all(lessThan(abs(texture(source, hw_v_uv) - kept), vec4(0.004)))"));
    const Case cases[]{{PixelFormat::r8, {0.25f, 0, 0, 1}},        {PixelFormat::rg8, {0.25f, 0.75f, 0, 1}},
                       {PixelFormat::rgba8, {0.25f, 0.75f, 1, 0}}, {PixelFormat::rgba16f, {0.25f, 0.75f, 1000.5f, -3}},
                       {PixelFormat::r32f, {0.25f, 0, 0, 1}},      {PixelFormat::rgba32f, {0.25f, 0.75f, 1000.5f, -3}}};
    for (const Case& c : cases)
        EXPECT_EQ(judged({.outputs = {{.format = c.format}}}, written, judging, Uniforms().set("kept", c.kept)), kGreen)
            << static_cast<int>(c.format);
}

TEST_F(targets, of_whole_numbers_keep_all_their_bits)
{
    const std::string read = "texelFetch(source, ivec2(10, 10), 0)";
    EXPECT_EQ(judged({.outputs = {{.format = PixelFormat::r32ui}}},
                     shaders_.full_screen(whole_number_writer("uint", "4000000007u")),
                     shaders_.full_screen(judge("uniform highp usampler2D source;", read + ".r == 4000000007u"))),
              kGreen);
    EXPECT_EQ(
        judged({.outputs = {{.format = PixelFormat::rg32ui}}},
               shaders_.full_screen(whole_number_writer("uvec2", "uvec2(7u, 4000000007u)")),
               shaders_.full_screen(judge("uniform highp usampler2D source;", read + ".rg == uvec2(7u, 4000000007u)"))),
        kGreen);
}

TEST_F(targets, are_filtered_as_they_say_and_floats_of_32_bits_never)
{
    // Columns of 0 and 1, sampled where two of them meet.
    const Program written = shaders_.full_screen(writer("vec4(mod(floor(gl_FragCoord.x), 2.0))"));
    const Program judging = shaders_.full_screen(judge(
        "uniform sampler2D source; uniform float is_mean;",
        "(abs(texture(source, vec2(160.0, 120.5) / vec2(textureSize(source, 0))).r - 0.5) < 0.1) == (is_mean > 0.5)"));
    const auto drawn = [&](PixelFormat format, PixelFilter filter, bool is_mean) {
        return judged({.outputs = {{.format = format, .filter = filter}}}, written, judging,
                      Uniforms().set("is_mean", is_mean ? 1.0f : 0.0f));
    };
    EXPECT_EQ(drawn(PixelFormat::rgba8, PixelFilter::linear, true), kGreen);
    EXPECT_EQ(drawn(PixelFormat::rgba16f, PixelFilter::linear, true), kGreen);
    EXPECT_EQ(drawn(PixelFormat::rgba8, PixelFilter::nearest, false), kGreen);
    EXPECT_EQ(drawn(PixelFormat::r32f, PixelFilter::linear, false), kGreen);
    EXPECT_EQ(drawn(PixelFormat::rgba32f, PixelFilter::linear, false), kGreen);
}

TEST_F(targets, go_on_beyond_their_edge_as_they_say)
{
    const Program written = shaders_.full_screen(writer("vec4(hw_v_uv.x)"));
    const Program judging = shaders_.full_screen(judge("uniform sampler2D source; uniform float wanted;",
                                                       "abs(texture(source, vec2(1.25, 0.5)).r - wanted) < 0.02"));
    const std::pair<PixelWrap, float> cases[]{
        {PixelWrap::clamp, 1.0f}, {PixelWrap::repeat, 0.25f}, {PixelWrap::mirrored_repeat, 0.75f}};
    for (const auto& [wrap, wanted] : cases)
        EXPECT_EQ(judged({.outputs = {{.wrap = wrap}}}, written, judging, Uniforms().set("wanted", wanted)), kGreen)
            << wanted;
}

TEST_F(targets, hold_what_they_are_cleared_to_where_nothing_is_drawn)
{
    const Program faces =
        shaders_.surface("#include \"surface.glsl\"\nvoid main() { hw_surface(); hw_fragment = vec4(1.0); }\n");
    const Program judging =
        shaders_.full_screen(judge("uniform sampler2D first; uniform sampler2D second; uniform highp usampler2D third;",
                                   "distance(texture(first, hw_v_uv), vec4(0.2, 0.4, 0.6, 0.8)) < 0.01 && "
                                   "texture(second, hw_v_uv) == vec4(0.0) && texelFetch(third, ivec2(5), 0).r == 7u"));
    const TargetDesc target{
        .outputs = {{.clear = {0.2f, 0.4f, 0.6f, 0.8f}}, {}, {.format = PixelFormat::r32ui, .clear = glm::vec4(7.6f)}}};
    EXPECT_EQ(shown([&](Pass& pass, Items) {
                  const Images made = pass.render(target, faces, {}, {});
                  return pass.filter({}, judging,
                                     Uniforms().set("first", made[0]).set("second", made[1]).set("third", made[2]))[0];
              }),
              kGreen);
}

TEST_F(targets, are_so_large_a_part_of_the_view_rounded_up_and_within_limits)
{
    const Program written = shaders_.full_screen(writer("vec4(1.0)"));
    const std::pair<float, glm::ivec2> cases[]{
        {0.3f, {97, 73}}, {1.0f, {321, 241}}, {0.0f, {4, 3}}, {9.0f, {1284, 964}}, {std::nanf(""), {4, 3}}};
    for (const auto& [scale, size] : cases) {
        glm::ivec2 made{0};
        shown(
            [&, scale = scale](Pass& pass, Items) {
                const Image image = pass.filter({.scale = scale}, written, {})[0];
                made = image.size_px;
                return image;
            },
            {321, 241});
        EXPECT_EQ(made, size) << scale;
    }
}

TEST_F(targets, larger_than_the_device_takes_are_not_made_and_the_log_says_so_once)
{
    const Program written = shaders_.full_screen(writer("vec4(1.0)"));
    set_log_level(LogLevel::error);
    testing::internal::CaptureStderr();
    std::size_t made = 9;
    for (int i = 0; i < 2; ++i)
        shown(
            [&](Pass& pass, Items) {
                made = pass.filter({.scale = 4.0f}, written, {}).size();
                return Image();
            },
            {9000, 8});
    const std::string log = testing::internal::GetCapturedStderr();
    set_log_level(LogLevel::off);
    EXPECT_EQ(made, 0u);
    EXPECT_NE(log.find("36000"), std::string::npos) << log;
    EXPECT_EQ(log.find("36000", log.find("36000") + 5), std::string::npos) << log;
}

TEST_F(targets, hide_items_behind_each_other_or_lay_them_over_each_other_as_depth_says)
{
    // Behind the first box.
    add_object(scene_, box_mesh(glm::vec3(3.0f, 3.0f, 0.1f)), glm::translate(glm::dmat4(1.0), {0, 0, -2}),
               painted(glm::vec3(1.0f)));
    const Program numbers = shaders_.surface(
        "#include \"surface.glsl\"\nvoid main() { HwSurface s = hw_surface();\n"
        "hw_fragment = s.object_id == 1u ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(0.0, 0.0, 1.0, 1.0); }\n");
    const auto drawn = [&](TargetDepth depth) {
        return shown([&](Pass& pass, Items items) { return pass.render({.depth = depth}, numbers, {}, items)[0]; });
    };
    EXPECT_EQ(drawn(TargetDepth::own), kGreen);
    EXPECT_EQ(drawn(TargetDepth::scene), kGreen);
    EXPECT_EQ(drawn(TargetDepth::none), glm::ivec3(0, 0, 255)) << "near before far, and the last lies on top";
    const auto last_alone = [&](TargetDepth depth) {
        return shown(
            [&](Pass& pass, Items items) { return pass.render({.depth = depth}, numbers, {}, items.last(1))[0]; });
    };
    EXPECT_EQ(last_alone(TargetDepth::own), glm::ivec3(0, 0, 255)) << "what is no item of the pass hides nothing";
    EXPECT_EQ(last_alone(TargetDepth::scene), glm::ivec3(0)) << "the first box is before it";
}

TEST_F(targets, of_one_pass_are_four_and_each_has_its_location)
{
    const Program faces = shaders_.surface(
        "#define HW_OWN_OUTPUTS\n#include \"surface.glsl\"\n"
        "layout(location = 0) out vec4 a;\nlayout(location = 1) out uint b;\n"
        "layout(location = 2) out vec4 c;\nlayout(location = 3) out vec4 d;\n"
        "void main() { hw_surface(); a = vec4(0.25); b = 70000u; c = vec4(-2.0); d = vec4(1.0); }\n");
    const Program judging = shaders_.full_screen(
        judge("uniform sampler2D a; uniform highp usampler2D b; uniform sampler2D c; uniform sampler2D d;",
              "abs(texture(a, vec2(0.5)).r - 0.25) < 0.01 && texelFetch(b, ivec2(160, 120), 0).r == 70000u && "
              "texture(c, vec2(0.5)).a == -2.0 && texture(d, vec2(0.5)).b == 1.0"));
    const TargetDesc target{.outputs = {{.format = PixelFormat::r8},
                                        {.format = PixelFormat::r32ui},
                                        {.format = PixelFormat::rgba16f},
                                        {.format = PixelFormat::rgba8}}};
    EXPECT_EQ(shown([&](Pass& pass, Items items) {
                  const Images made = pass.render(target, faces, {}, items);
                  EXPECT_EQ(made.size(), kMaxTargetOutputs);
                  Uniforms all;
                  all.set("a", made[0]).set("b", made[1]).set("c", made[2]).set("d", made[3]);
                  return pass.filter({}, judging, all)[0];
              }),
              kGreen);
}

TEST_F(targets, of_another_size_are_measured_by_themselves_and_the_view_keeps_its_size)
{
    const Program written = shaders_.full_screen(
        "#include \"full_screen.glsl\"\nvoid main() { vec2 at = gl_FragCoord.xy / (0.5 * hw_size_px);\n"
        "bool is_right = hw_size_px == vec2(320.0, 240.0) && distance(at, hw_v_uv) < 1e-3;\n"
        "hw_fragment = vec4(is_right ? 1.0 : 0.0, hw_v_uv, 1.0); }\n");
    const Program judging = shaders_.full_screen(
        judge("uniform sampler2D source;",
              "textureSize(source, 0) == ivec2(160, 120) && texture(source, vec2(0.25, 0.75)).r == 1.0 && "
              "texture(source, vec2(0.25, 0.75)).b > texture(source, vec2(0.25, 0.25)).b"));
    EXPECT_EQ(judged({.scale = 0.5f}, written, judging), kGreen) << "from the bottom left";
}

TEST_F(targets, that_nobody_made_are_sampled_as_opaque_black)
{
    const Program judging = shaders_.full_screen(
        judge("uniform sampler2D source;", "texture(source, hw_v_uv) == vec4(0.0, 0.0, 0.0, 1.0)"));
    EXPECT_EQ(shown([&](Pass& pass, Items) { return pass.filter({}, judging, Uniforms().set("source", Image()))[0]; }),
              kGreen);
}

TEST_F(targets, are_not_filled_by_programs_that_were_made_for_something_else)
{
    const std::string faces = "#include \"surface.glsl\"\nvoid main() { hw_surface(); hw_fragment = vec4(0.0); }\n";
    const std::string pen =
        "#include \"line_pen.glsl\"\nvoid main() { HwLine l = hw_line(); hw_output(vec3(0.0), 1.0); }\n";
    const Program for_faces = shaders_.surface(faces), for_lines = shaders_.line(pen);
    const Program for_screen = shaders_.full_screen(writer("vec4(0.0)"));
    ScriptedStyle style;
    style.needed.edges = EdgeNeed{};
    std::vector<std::size_t> made;
    style.makes_images = [&](Pass& pass, Items items) {
        for (const Program& wrong : {for_faces, for_lines, Program{}, Program{9999}})
            made.push_back(pass.filter({}, wrong, {}).size());
        for (const Program& wrong : {for_screen, for_lines, Program{}, Program{9999}})
            made.push_back(pass.render({}, wrong, {}, items).size());
    };
    style.draws_surfaces = [&](Pass& pass, Items items) {
        for (const Program& wrong : {for_screen, for_lines, Program{}, Program{9999}}) pass.surfaces(wrong, {}, items);
    };
    style.draws_lines = [&](Pass& pass, Items items) {
        for (const Program& wrong : {for_screen, for_faces, Program{}, Program{9999}})
            pass.lines(wrong, {}, LineLook(), items);
    };
    load(style);
    EXPECT_EQ(count_dark(draw(view_from({0, 0, 4}, {0, 0, 0}))), 0);
    EXPECT_THAT(made, testing::ElementsAre(0, 0, 0, 0, 0, 0, 0, 0));
}

TEST_F(targets, get_uniforms_of_every_type_and_ignore_those_that_no_shader_has)
{
    const Program judging = shaders_.full_screen(judge(
        "uniform float a; uniform int b; uniform vec2 c; uniform vec3 d; uniform vec4 e;",
        "a == 0.25 && b == -3 && c == vec2(1.0, 2.0) && d == vec3(3.0, 4.0, 5.0) && e == vec4(6.0, 7.0, 8.0, 9.0)"));
    EXPECT_EQ(shown([&](Pass& pass, Items) {
                  Uniforms all;
                  all.set("a", 0.25f).set("b", -3).set("c", glm::vec2(1, 2)).set("d", glm::vec3(3, 4, 5));
                  all.set("e", glm::vec4(6, 7, 8, 9)).set("nobody_has_this", 1.0f).set("nor_this", Image());
                  return pass.filter({}, judging, all)[0];
              }),
              kGreen);
}

TEST_F(targets, colours_of_parameters_are_set_as_linear_light)
{
    EXPECT_NEAR(linear_colour(glm::vec3(0.5f)).r, 0.21404f, 1e-4f);
    EXPECT_EQ(linear_colour({0.0f, 1.0f, 0.02f}).g, 1.0f);
    EXPECT_NEAR(linear_colour({0.0f, 1.0f, 0.02f}).b, 0.02f / 12.92f, 1e-6f);
}

TEST_F(targets, an_image_that_is_invalid_is_black_also_in_a_frame_after_one_in_which_it_was_not)
{
    const Program white = shaders_.full_screen(writer("vec4(1.0)"));
    const Program copy = shaders_.full_screen(
        "#include \"full_screen.glsl\"\nuniform sampler2D source;\nvoid main() { hw_fragment = texture(source, "
        "hw_v_uv); "
        "}\n");
    ScriptedStyle style;
    bool is_valid = true;
    Image copied;
    style.makes_images = [&](Pass& pass, Items) {
        const Image source = is_valid ? pass.filter({}, white, {})[0] : Image();
        copied = pass.filter({}, copy, Uniforms().set("source", source))[0];
    };
    style.draws_surfaces = [&](Pass& pass, Items items) {
        pass.surfaces(show_, Uniforms().set("shown", copied), items);
    };
    load(style);
    for (const int wanted : {255, 0}) {
        EXPECT_EQ(draw(view_from({0, 0, 4}, {0, 0, 0}), {.samples = 1}).at(160, 120)[0], wanted);
        is_valid = false;
    }
}

}  // namespace
}  // namespace hw::test
