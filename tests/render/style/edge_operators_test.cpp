// The operators of the edge map on images made by hand, with values worked by hand from the paper's equations.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/render/style/scripted_style.hpp"

namespace hw::test {
namespace {

const glm::ivec2 kSize(32, 24);
const glm::ivec2 kX(16, 12);  // the pixel in the middle, from the bottom left

/// The neighbours of the paper's figure 2, as GLSL: A B C above, D X E, F G H below.
std::string three_by_three(const std::array<std::string, 9>& pixels)
{
    std::string text = "ivec2 o = p - ivec2(16, 12);\n";
    for (int i = 0; i < 9; ++i)
        text += "if (o == ivec2(" + std::to_string(i % 3 - 1) + ", " + std::to_string(1 - i / 3) + ")) return " +
                pixels[static_cast<std::size_t>(i)] + ";\n";
    return text + "return vec4(0.0, 0.0, 1.0, 5.0);\n";
}

class edge_operators : public RendererTest {
 protected:
    edge_operators() : operators_(renderer_->program_cache(HATCHWAY_SOURCE_DIR "/npr_plugins/edge_map"))
    {
        add_object(scene_, box_mesh(glm::vec3(1.0f)), glm::dmat4(1.0), painted(glm::vec3(1.0f)));
    }

    /// What an operator makes of an image of normals and depths, `made_by` the pixel `p`: R and G are bytes, rows from
    /// the bottom.
    Pixels edges(const std::string& file, const std::string& made_by, Uniforms uniforms)
    {
        const Program source = shaders_.full_screen("#include \"full_screen.glsl\"\nvec4 made(ivec2 p) {\n" + made_by +
                                                    "}\nvoid main() { hw_fragment = made(ivec2(gl_FragCoord.xy)); }\n");
        const Program find = operators_.full_screen(file, defines_);
        // Linear bytes arrive in the picture as sRGB: undo that here, so that the test reads what was made.
        const Program show = shaders_.full_screen(
            "#include \"full_screen.glsl\"\nuniform sampler2D shown;\nvoid main() { vec3 c = texelFetch(shown, "
            "ivec2(gl_FragCoord.xy), 0).rgb;\n"
            "hw_fragment = vec4(mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c)), 1.0); }\n");
        ScriptedStyle style;
        Image made;
        style.makes_images = [&](Pass& pass, Items) {
            const Image image = pass.filter({.outputs = {{.format = format_}}}, source, {})[0];
            uniforms.set("normal_depth", image).set("reach_px", glm::vec3(1.0f, 1.0f, 0.0f));
            made = make_ ? make_(pass, find, uniforms) : pass.filter({}, find, uniforms)[0];
        };
        style.draws_lines = [&](Pass& pass, Items) { pass.cover(show, Uniforms().set("shown", made)); };
        load(style);
        return draw(view_from({0, 0, 4}, {0, 0, 0}, kSize), {.samples = 1});
    }

    static glm::ivec2 at(const Pixels& picture, glm::ivec2 from_bottom_left)
    {
        const std::uint8_t* rgb = picture.at(from_bottom_left.x, kSize.y - 1 - from_bottom_left.y);
        return {rgb[0], rgb[1]};
    }
    static int byte(double value) { return static_cast<int>(255.0 * value + 0.5); }

    static Uniforms of_2003() { return Uniforms().set("depth_range_m", glm::vec2(0.0f, 10.0f)).set("radius_px", 1); }
    static Uniforms ours(float gap = 0.005f)
    {
        const glm::vec2 cosines(std::cos(glm::radians(40.0f)), std::cos(glm::radians(36.0f)));
        return Uniforms().set("crease_cosines", cosines).set("gap", gap);
    }

    ShaderFolder shaders_{*renderer_};
    ProgramCache& operators_;
    std::string defines_;
    PixelFormat format_ = PixelFormat::rgba32f;
    std::function<Image(Pass&, Program, const Uniforms&)> make_;
};

// A and H look 90 degrees apart, C and F the same way: I_N = (0 + 1) / 2. Depths over 10 m: |A - H| = 0.4, |C - F| =
// 0.2, so I_Z = (1 - 0.2)^2 (1 - 0.1)^2 = 0.5184.
const std::string kDiagonalPatch =
    three_by_three({"vec4(0, 0, 1, 2)", "vec4(0, 0, 1, 9)", "vec4(0, 0, 1, 1)", "vec4(0, 1, 0, 9)", "vec4(0, 0, 1, 5)",
                    "vec4(0, 1, 0, 1)", "vec4(0, 0, 1, 3)", "vec4(1, 0, 0, 2)", "vec4(1, 0, 0, 6)"});

TEST_F(edge_operators, diagonal_is_the_papers_i_n_and_i_z)
{
    const glm::ivec2 x = at(edges("diagonal.frag", kDiagonalPatch, of_2003()), kX);
    EXPECT_NEAR(x.x, byte(0.5), 1);
    EXPECT_NEAR(x.y, byte(0.5184), 1);
}

TEST_F(edge_operators, diagonal_is_the_same_on_bytes_but_for_their_steps)
{
    defines_ = "#define NORMAL_DEPTH_BYTES 1\n";
    format_ = PixelFormat::rgba8;
    // As normal_depth of format rgba8 holds the patch over 0 to 10 m.
    const auto as_bytes = [](double x, double y, double z, double metres) {
        return "vec4(" + std::to_string(0.5 * x + 0.5) + ", " + std::to_string(0.5 * y + 0.5) + ", " +
               std::to_string(0.5 * z + 0.5) + ", " + std::to_string(metres / 10.0) + ")";
    };
    const std::string patch = three_by_three({as_bytes(0, 0, 1, 2), as_bytes(0, 0, 1, 9), as_bytes(0, 0, 1, 1),
                                              as_bytes(0, 1, 0, 9), as_bytes(0, 0, 1, 5), as_bytes(0, 1, 0, 1),
                                              as_bytes(0, 0, 1, 3), as_bytes(1, 0, 0, 2), as_bytes(1, 0, 0, 6)});
    const glm::ivec2 x = at(edges("diagonal.frag", patch, of_2003()), kX);
    EXPECT_NEAR(x.x, byte(0.5), 3);
    EXPECT_NEAR(x.y, byte(0.5184), 3);
}

TEST_F(edge_operators, i_n_of_normals_that_look_apart_is_no_less_than_0)
{
    const std::string up = "vec4(0, 1, 0, 5)", down = "vec4(0, -1, 0, 5)";
    const std::string patch = three_by_three({up, up, up, up, up, up, down, down, down});
    EXPECT_EQ(at(edges("diagonal.frag", patch, of_2003()), kX).x, 0);
}

// (0.3 + 2 * 0.1 + 0.4 + 2 * 0 + 2 * 0.4 + 0.2 + 2 * 0.2 + 0.1) / 8 = 0.3; kept as 1 - 0.3. In three passes the sums
// 0.1125 and 0.2125 are stored in eight bits between.
TEST_F(edge_operators, c1_is_the_papers_sum_in_one_pass_and_in_three)
{
    const auto z = [](const char* metres) { return std::string("vec4(0, 0, 1, ") + metres + ")"; };
    const std::string patch = three_by_three({z("2"), z("4"), z("1"), z("5"), z("5"), z("9"), z("3"), z("7"), z("6")});
    const glm::ivec2 once = at(edges("c1.frag", patch, of_2003()), kX);
    EXPECT_EQ(once.x, 255);
    EXPECT_NEAR(once.y, byte(0.7), 1);
    const Program part = operators_.full_screen("c1_part.frag");
    make_ = [&](Pass& pass, Program find, const Uniforms& uniforms) {
        Image sum;
        for (int i = 0; i < 2; ++i)
            sum = pass.filter({.outputs = {{.format = PixelFormat::rg8}}}, part,
                              Uniforms(uniforms).set("part", i).set("sum_before", sum))[0];
        return pass.filter({}, find, Uniforms(uniforms).set("part", 2).set("sum_before", sum))[0];
    };
    defines_ = "#define IN_THREE_PASSES 1\n";
    const glm::ivec2 thrice = at(edges("c1.frag", patch, of_2003()), kX);
    EXPECT_NEAR(thrice.y, byte(0.7), 2);
    EXPECT_EQ(thrice.x, 255);
}

// The depth of a plane seen at a grazing angle: 1 / z falls by 0.004 a row, to a horizon far above.
const std::string kFloor = "return vec4(0.0, 1.0, 0.0, 1.0 / (0.11 - 0.004 * float(p.y)));\n";

TEST_F(edge_operators, ours_leaves_a_plane_white_where_the_papers_sees_edges)
{
    const Pixels our = edges("second_difference.frag", kFloor, ours(1e-4f));
    for (int y = 0; y < kSize.y; ++y) EXPECT_EQ(at(our, {16, y}), glm::ivec2(255)) << y;
    const Uniforms range = Uniforms().set("depth_range_m", glm::vec2(9.0f, 60.0f)).set("radius_px", 1);
    EXPECT_LT(at(edges("diagonal.frag", kFloor, range), {16, 22}).y, 200)
        << "far up each row is metres behind the last";
}

// From 10 m to 10.04 m: the gap is 0.1 - 1 / 10.04 = 0.00039841, of the nearer 0.1 that is 0.0039841. Between half of a
// gap of 0.005 and all of it: t = 0.59363, t^2 (3 - 2 t) = 0.63881.
TEST_F(edge_operators, a_step_in_depth_is_an_edge_of_the_nearer_side_and_its_height_the_intensity)
{
    const std::string step = "return vec4(0.0, 0.0, 1.0, p.x < 16 ? 10.0 : 10.04);\n";
    const Pixels picture = edges("second_difference.frag", step, ours());
    EXPECT_EQ(at(picture, {14, 12}), glm::ivec2(255));
    EXPECT_NEAR(at(picture, {15, 12}).y, byte(1.0 - 0.63881), 1);
    EXPECT_EQ(at(picture, {16, 12}), glm::ivec2(255)) << "the farther side";
    EXPECT_EQ(at(picture, {15, 12}).x, 255) << "no inner edge";
}

TEST_F(edge_operators, nothing_is_farther_than_all)
{
    const std::string sheet = "return p.y < 12 ? vec4(0.0, 0.0, 1.0, 500.0) : vec4(0.0);\n";
    const Pixels picture = edges("second_difference.frag", sheet, ours());
    EXPECT_EQ(at(picture, {16, 11}), glm::ivec2(255, 0));
    EXPECT_EQ(at(picture, {16, 12}), glm::ivec2(255));
}

// Two planes that meet at x = 16.1, a tenth of a pixel beyond the middle between the centres 15.5 and 16.5: 1 / z falls
// by 0.01 to both sides of 0.1. The edge lies 0.6 and 0.4 pixels from the centres; a pen one pixel wide covers 1 - 0.6
// and 1 - 0.4.
TEST_F(edge_operators, a_fold_is_an_inner_edge_at_its_place_between_two_pixels)
{
    const std::string roof =
        "float x = float(p.x) + 0.5 - 16.1;\n"
        "return vec4(x < 0.0 ? vec3(-0.8, 0.0, 0.6) : vec3(0.8, 0.0, 0.6), 1.0 / (0.1 - 0.002 * abs(x)));\n";
    make_ = [](Pass& pass, Program find, const Uniforms& given) {
        return pass.filter({}, find, Uniforms(given).set("reach_px", glm::vec3(0.5f, 1.0f, 0.0f)))[0];
    };
    const Pixels picture = edges("second_difference.frag", roof, ours());
    EXPECT_NEAR(at(picture, {15, 12}).x, byte(1.0 - 0.4), 2);
    EXPECT_NEAR(at(picture, {16, 12}).x, byte(1.0 - 0.6), 2);
    EXPECT_EQ(at(picture, {14, 12}).x, 255);
    EXPECT_EQ(at(picture, {17, 12}).x, 255);
    EXPECT_EQ(at(picture, {15, 12}).y, 255) << "no profile edge: the planes meet";
}

// A chamfer of 60 degrees from x = 16 to 16.8 between two walls that look at the eye: one sample lies on it. With the
// focal length of 20.785 pixels its 1 / z is (1 - 1.7321 (x - 16) / 20.785) / 10, and 0.093333 on the wall behind.
// Straight on from that wall's pixel, the chamfer would leave a gap of 0.0017, of 0.1 that is more than 1 %: a step
// that is none.
TEST_F(edge_operators, a_chamfer_of_one_pixel_is_two_folds_and_no_step)
{
    const std::string chamfer =
        "float x = (float(p.x) + 0.5 - 16.0) / 20.785;\n"
        "if (p.x < 16) return vec4(0.0, 0.0, 1.0, 10.0);\n"
        "if (p.x > 16) return vec4(0.0, 0.0, 1.0, 1.0 / 0.093333);\n"
        "return vec4(0.866025, 0.0, 0.5, 10.0 / (1.0 - 1.7321 * x));\n";
    const Pixels picture = edges("second_difference.frag", chamfer, ours(0.01f));
    for (int x = 13; x < 20; ++x) EXPECT_EQ(at(picture, {x, 12}).y, 255) << x;
    for (int x = 15; x <= 17; ++x) EXPECT_LT(at(picture, {x, 12}).x, 128) << x;
}

// cos 38 degrees lies between cos 40 and cos 36: t = (0.788011 - 0.766044) / (0.809017 - 0.766044) = 0.511174.
TEST_F(edge_operators, the_fold_is_the_intensity_of_an_inner_edge)
{
    for (const auto& [deg, strength] : {std::pair(30.0, 0.0), {38.0, 1.0 - 0.51676}, {45.0, 1.0}}) {
        const std::string tilt = std::to_string(glm::radians(deg));
        const std::string roof =
            "return p.x < 16 ? vec4(0.0, 0.0, 1.0, 10.0) : vec4(0.0, sin(" + tilt + "), cos(" + tilt + "), 10.0);\n";
        EXPECT_NEAR(at(edges("second_difference.frag", roof, ours()), {15, 12}).x, byte(1.0 - strength), 1) << deg;
    }
}

}  // namespace
}  // namespace hw::test
