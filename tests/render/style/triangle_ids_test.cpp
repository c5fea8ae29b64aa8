// Numbers of triangles, what is known of their neighbours, and the edges between those that share no corner: on images
// made by hand, with values worked by hand.
#include <gmock/gmock.h>

#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>

#include "hatchway/render/products/triangle_tables.hpp"
#include "tests/render/style/scripted_style.hpp"

namespace hw::test {
namespace {

const glm::ivec2 kSize(32, 24);
const glm::ivec2 kRight(16, 12), kLeft(15, 12);  // the pixels beside the crack in the middle, from the bottom left
constexpr std::uint32_t kAbove2To24 = (1u << 24) + 5u;

/// A mesh of triangles that share no vertices, only their places.
MeshData soup(const std::vector<glm::vec3>& corners)
{
    MeshData mesh;
    for (const glm::vec3& corner : corners) {
        mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        mesh.positions.push_back(corner);
        mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
    }
    mesh.has_own_normals = true;
    return mesh;
}

/// 1 and 2 share an edge, 3 a corner with 2 and winds the other way, 4 lies apart and is a thousandth as high; 5 is
/// another object.
void add_triangles(Scene& scene)
{
    const glm::vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(1, 1, 0), e(2, 2, 0), f(2, 1, 0);
    add_object(scene, soup({a, b, c, c, b, d, d, e, f, {5, 0, 0}, {6, 0, 0}, {5, 0.001f, 0}}), glm::dmat4(1.0),
               painted(glm::vec3(1.0f)));
    add_object(scene, soup({{0, 5, 0}, {1, 5, 0}, {0, 6, 0}}), glm::dmat4(1.0), painted(glm::vec3(1.0f)));
}

std::vector<std::uint32_t> star_of(const CornerStars& stars, std::uint32_t triangle, std::uint32_t corner)
{
    const glm::uvec2 star = stars.of_corner[3 * (triangle - 1) + corner];
    const auto first = stars.triangles.begin() + star.x;
    return {first, first + star.y};
}

class triangle_ids : public RendererTest {
 protected:
    triangle_ids() : operators_(renderer_->program_cache(HATCHWAY_SOURCE_DIR "/npr_plugins/edge_map"))
    {
        add_triangles(scene_);
    }

    /// The edges between a left half of one triangle with one plane (nearness, steps to the right and upwards) and a
    /// right half of another.
    Pixels edges(int left, int right, const glm::vec3& left_plane = {0.1f, 0, 0},
                 const glm::vec3& right_plane = {0.1f, 0, 0})
    {
        const Program source = shaders_.full_screen(
            "#define HW_OWN_OUTPUTS\n#include \"full_screen.glsl\"\nuniform int left, right;\nuniform vec3 left_plane, "
            "right_plane;\nlayout(location = 0) out uint id;\nlayout(location = 1) out vec4 plane;\nvoid main() {\n"
            "float x = gl_FragCoord.x - 16.0;\nvec3 p = x < 0.0 ? left_plane : right_plane;\n"
            "id = uint(x < 0.0 ? left : right);\nplane = vec4(p.x + x * p.y, p.yz, 1.0 / p.x); }\n");
        std::string defines = is_of_2011_ ? "#define IDS_OF_2011 1\n" : "";
        if (by_lists_) defines += "#define TRIANGLES_BY_STARS 1\n";
        const Program find = operators_.full_screen("ids.frag", defines);
        const Program show = shaders_.full_screen(
            "#include \"full_screen.glsl\"\nuniform sampler2D shown;\nvoid main() { vec3 c = texelFetch(shown, "
            "ivec2(gl_FragCoord.xy), 0).rgb;\n"
            "hw_fragment = vec4(mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c)), 1.0); }\n");
        ScriptedStyle style;
        style.needed.images = {{"triangle_corners", {}}, {"triangle_stars", {}}};
        Image made;
        style.makes_images = [&](Pass& pass, Items) {
            const Images given =
                pass.filter({.outputs = {{.format = PixelFormat::r32ui}, {.format = PixelFormat::rgba32f}}}, source,
                            Uniforms()
                                .set("left", left)
                                .set("right", right)
                                .set("left_plane", left_plane)
                                .set("right_plane", right_plane));
            made = pass.filter({}, find,
                               Uniforms()
                                   .set("triangle_ids", given[0])
                                   .set("planes", given[1])
                                   .set("triangle_corners", pass.image({"triangle_corners", {}}))
                                   .set("triangle_stars", pass.image({"triangle_stars", {}}))
                                   .set("star_triangles", pass.image({"triangle_stars", {}}, 1))
                                   .set("gap", 0.01f)
                                   .set("small_px", small_px_)
                                   .set("reach_px", glm::vec3(0.5f, 1.0f, 0.0f)))[0];
        };
        style.draws_lines = [&](Pass& pass, Items) { pass.cover(show, Uniforms().set("shown", made)); };
        load(style);
        return draw(view_from({1, 1, 9}, {1, 1, 0}, kSize), {.samples = 1});
    }
    static glm::ivec3 at(const Pixels& picture, glm::ivec2 from_bottom_left)
    {
        const std::uint8_t* rgb = picture.at(from_bottom_left.x, kSize.y - 1 - from_bottom_left.y);
        return {rgb[0], rgb[1], rgb[2]};
    }

    ShaderFolder shaders_{*renderer_};
    ProgramCache& operators_;
    bool is_of_2011_ = false, by_lists_ = false;
    float small_px_ = 0.0f;
};

const glm::ivec3 kNone3(255), kOutline(255, 0, 255), kBorder(255, 0, 0);

TEST_F(triangle_ids, corners_of_a_soup_are_one_where_their_places_are)
{
    const CornerStars stars = corner_stars(triangle_corners(scene_));
    using testing::ElementsAre;
    EXPECT_THAT(star_of(stars, 1, 0), ElementsAre(1));
    EXPECT_THAT(star_of(stars, 1, 1), ElementsAre(1, 2));
    EXPECT_THAT(star_of(stars, 2, 2), ElementsAre(2, 3));
    EXPECT_THAT(star_of(stars, 3, 0), ElementsAre(2, 3));
    EXPECT_THAT(star_of(stars, 4, 0), ElementsAre(4));
    EXPECT_EQ(stars.triangles.size(), 15u);
}

TEST_F(triangle_ids, three_faces_at_one_edge_are_all_neighbours)
{
    Scene scene;
    const glm::vec3 a(0, 0, 0), b(0, 1, 0);
    add_object(scene, soup({a, b, {1, 0, 0}, a, b, {-1, 0, 0}, b, a, {0, 0, 1}}), glm::dmat4(1.0), Material{});
    const CornerStars stars = corner_stars(triangle_corners(scene));
    for (std::uint32_t triangle = 1; triangle <= 3; ++triangle)
        EXPECT_THAT(star_of(stars, triangle, 0), testing::ElementsAre(1, 2, 3));
}

TEST_F(triangle_ids, corners_at_plus_and_minus_0_and_of_objects_that_were_moved_together_are_one)
{
    Scene scene;
    add_object(scene, soup({{0.0f, 0, 0}, {1, 0, 0}, {0, 1, 0}}), glm::dmat4(1.0), Material{});
    add_object(scene, soup({{-0.0f, 0, 0}, {1, 0, 0}, {0, -1, 0}}), glm::dmat4(1.0), Material{});
    add_object(scene, soup({{0.3f, 0, 0}, {1, 5, 0}, {0, 6, 0}}),
               glm::translate(glm::dmat4(1.0), glm::dvec3(-0.3f, 0, 0)), Material{});
    EXPECT_THAT(star_of(corner_stars(triangle_corners(scene)), 1, 0), testing::ElementsAre(1, 2, 3));
}

TEST_F(triangle_ids, triangles_with_a_common_edge_or_corner_have_no_line_between)
{
    for (const bool lists : {false, true})
        for (const bool paper : {false, true}) {
            by_lists_ = lists, is_of_2011_ = paper;
            for (const auto& [left, right] : {std::pair(1, 2), {2, 3}, {3, 2}})
                EXPECT_EQ(at(edges(left, right), kLeft), kNone3) << left << '|' << right;
        }
}

TEST_F(triangle_ids, of_2011_marks_both_sides_between_triangles_without_a_common_corner)
{
    is_of_2011_ = true;
    for (const bool lists : {false, true}) {
        by_lists_ = lists;
        for (const auto& [left, right] : {std::pair(1, 3), {1, 4}, {1, 5}}) {
            const Pixels picture = edges(left, right);
            EXPECT_EQ(at(picture, kLeft).y, 0);
            EXPECT_EQ(at(picture, kRight).y, 0);
            EXPECT_EQ(at(picture, kLeft - glm::ivec2(1, 0)), kNone3);
        }
    }
}

// Nearness 0.1 on the left and 0.09 on the right, both flat: the left plane, going on, lies before the right one.
TEST_F(triangle_ids, the_triangle_before_the_other_has_the_edge_a_border_within_one_object_else_an_outline)
{
    for (const bool lists : {false, true}) {
        by_lists_ = lists;
        const Pixels within = edges(1, 4, {0.1f, 0, 0}, {0.09f, 0, 0}), other = edges(5, 1, {0.09f, 0, 0});
        EXPECT_EQ(at(within, kLeft), kBorder);
        EXPECT_EQ(at(within, kRight), kNone3);
        EXPECT_EQ(at(other, kRight), kOutline);
        EXPECT_EQ(at(other, kLeft), kNone3);
    }
}

// The left falls by 0.01 a pixel from 0.105 half a pixel before the middle; going on to the right it would lie at
// 0.095, behind the right one's 0.0999, which, going on to the left at 0.0999, lies behind 0.105: each is seen on its
// own side.
// 1 and 2 share an edge: where that edge is between the pixels their planes meet. A step of half a percent tells that
// one is folded over the other. 2 and 3 share a corner alone: there it takes more than a percent.
TEST_F(triangle_ids, joined_triangles_have_an_edge_where_one_is_folded_over_the_other)
{
    for (const bool lists : {false, true}) {
        by_lists_ = lists;
        EXPECT_EQ(at(edges(1, 2, {0.1f, -0.001f, 0}, {0.1f, 0.001f, 0}), kLeft), kNone3) << "a roof";
        EXPECT_EQ(at(edges(1, 2, {0.1f, 0, 0}, {0.0995f, 0, 0}), kLeft), kBorder);
        EXPECT_EQ(at(edges(1, 2, {0.1f, 0, 0}, {0.0995f, 0, 0}), kRight), kNone3);
        EXPECT_EQ(at(edges(2, 3, {0.1f, 0, 0}, {0.0995f, 0, 0}), kLeft), kNone3);
        EXPECT_EQ(at(edges(2, 3, {0.1f, 0, 0}, {0.098f, 0, 0}), kLeft), kBorder);
    }
}

TEST_F(triangle_ids, planes_that_meet_are_an_inner_edge_half_on_each_side)
{
    const Pixels picture = edges(1, 5, {0.1f, -0.01f, 0}, {0.0999f, 0, 0});
    EXPECT_NEAR(at(picture, kLeft).x, 127, 1);
    EXPECT_NEAR(at(picture, kRight).x, 127, 1);
    EXPECT_EQ(at(picture, kLeft).y, 255);
}

TEST_F(triangle_ids, what_stands_before_nothing_has_an_outline_on_its_own_side)
{
    for (const bool paper : {false, true}) {
        is_of_2011_ = paper;
        const Pixels picture = edges(1, 0);
        EXPECT_EQ(at(picture, kLeft), kOutline);
        EXPECT_EQ(at(picture, kRight), kNone3);
    }
}

// Triangle 4 is 0.001 m high; at nearness 0.1 with a focal length of 24 / (2 tan 30 deg) = 20.8 px that is 0.002 px.
TEST_F(triangle_ids, between_small_triangles_of_one_object_only_a_gap_is_an_edge)
{
    small_px_ = 1.0f;
    EXPECT_EQ(at(edges(1, 4), kLeft), kNone3) << "they meet";
    EXPECT_EQ(at(edges(1, 4, {0.1f, 0, 0}, {0.0995f, 0, 0}), kLeft), kNone3) << "half a percent";
    EXPECT_EQ(at(edges(1, 4, {0.1f, 0, 0}, {0.098f, 0, 0}), kLeft), kBorder) << "two percent";
    EXPECT_NEAR(at(edges(5, 4), kLeft).x, 127, 1) << "of two objects all is shown";
    small_px_ = 0.001f;
    EXPECT_NEAR(at(edges(1, 4), kLeft).x, 127, 1) << "and of larger ones";
}

TEST_F(triangle_ids, above_2_to_the_24_are_whole)
{
    // 258 objects share a mesh of 2^16 triangles; all but the last stand behind the eye.
    scene_ = {};
    MeshData mesh;
    for (int i = 0; i <= 256; ++i)
        for (int j = 0; j <= 128; ++j) mesh.positions.emplace_back(i / 256.0f, j / 128.0f, 0.0f);
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0, 0, 1));
    for (std::uint32_t i = 0; i < 256; ++i)
        for (std::uint32_t j = 0; j < 128; ++j) {
            const std::uint32_t k = i * 129 + j;
            for (const std::uint32_t corner : {k, k + 129, k + 130, k, k + 130, k + 1}) mesh.indices.push_back(corner);
        }
    ASSERT_EQ(mesh.triangle_count(), 1u << 16);
    add_object(scene_, mesh, glm::translate(glm::dmat4(1.0), {0, 0, 50}), painted(glm::vec3(1.0f)));
    for (int i = 1; i < 258; ++i) {
        Object object = scene_.objects[0];
        if (i == 257) {
            scene_.nodes.push_back({.name = "seen", .path = "seen"});
            object.node = 1;
            object.bounds_world = {};
            for (const glm::vec3& p : scene_.meshes[0].positions) object.bounds_world.add(glm::dvec3(p));
        }
        scene_.bounds_world.add(object.bounds_world);
        scene_.objects.push_back(object);
    }
    ScriptedStyle style;
    style.needed.images = {{"triangle_ids", {}}};
    const Program judge = shaders_.full_screen(
        "#include \"full_screen.glsl\"\nuniform highp usampler2D ids;\nvoid main() {\n"
        "highp uint first = 257u * 65536u + 1u;\n"
        "highp uint a = texelFetch(ids, ivec2(gl_FragCoord.xy), 0).r;\n"
        // Square k of the 256 by 128 has the triangles 2 k and 2 k + 1.
        "highp uint k = (a - first) / 2u;\nhw_fragment = vec4(a >= first && a < first + 65536u ? float(k / 128u) : "
        "0.0, float(k % 128u), 0.0, 255.0) / 255.0; }\n");
    const Program show = shaders_.full_screen(
        "#include \"full_screen.glsl\"\nuniform sampler2D shown;\nvoid main() { vec3 c = texelFetch(shown, "
        "ivec2(gl_FragCoord.xy), 0).rgb;\n"
        "hw_fragment = vec4(mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c)), 1.0); }\n");
    Image made;
    style.makes_images = [&](Pass& pass, Items) {
        made = pass.filter({}, judge, Uniforms().set("ids", pass.image({"triangle_ids", {}})))[0];
    };
    style.draws_lines = [&](Pass& pass, Items) { pass.cover(show, Uniforms().set("shown", made)); };
    load(style);
    // The square from 0 to 1 fills the picture of 256 x 256 but for its perspective: seen flat-on, 1 m is 256 px.
    const Pixels picture = draw(view_from({0.5, 0.5, 0.8660254}, {0.5, 0.5, 0}, {256, 256}), {.samples = 1});
    int wrong = 0;
    for (int y = 8; y < 248; ++y)
        for (int x = 8; x < 248; ++x) {
            wrong += std::abs(picture.at(x, y)[0] - x) > 1 ? 1 : 0;
            wrong += std::abs(picture.at(x, y)[1] - (255 - y) / 2) > 1 ? 1 : 0;
        }
    EXPECT_EQ(wrong, 0);
}

TEST_F(triangle_ids, of_a_real_mesh_above_2_to_the_24_are_whole_and_know_their_neighbours)
{
    if (std::getenv("HATCHWAY_WHOLE_CORPORA") == nullptr) GTEST_SKIP() << "takes gigabytes: ./check --all";
    constexpr std::uint32_t kColumns = 4096, kRows = 2050;  // of squares; a column is 1 m wide and 4 m high
    scene_ = {};
    MeshData mesh;
    for (std::uint32_t i = 0; i <= kColumns; ++i)
        for (std::uint32_t j = 0; j <= kRows; ++j)
            mesh.positions.emplace_back(static_cast<float>(i), 4.0f * static_cast<float>(j) / kRows, 0.0f);
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0, 0, 1));
    mesh.indices.reserve(std::size_t(6) * kColumns * kRows);
    for (std::uint32_t i = 0; i < kColumns; ++i)
        for (std::uint32_t j = 0; j < kRows; ++j) {
            const std::uint32_t k = i * (kRows + 1) + j, right = k + kRows + 1;
            for (const std::uint32_t corner : {k, right, right + 1, k, right + 1, k + 1})
                mesh.indices.push_back(corner);
        }
    ASSERT_GT(mesh.triangle_count(), (1u << 24) + 10'000u);
    add_object(scene_, std::move(mesh), glm::dmat4(1.0), painted(glm::vec3(1.0f)));
    ScriptedStyle style;
    style.needed.images = {{"triangle_ids", {}}, {"triangle_corners", {}}};
    const Program judge = shaders_.full_screen(
        "#include \"full_screen.glsl\"\n#include \"triangle_ids.glsl\"\nuniform highp usampler2D ids;\n"
        "void main() {\nhighp uint a = texelFetch(ids, ivec2(gl_FragCoord.xy), 0).r;\n"
        "highp uint k = (a - 1u) / 2u, other = 2u * k + 1u + a % 2u;\n"
        "bool right = hw_is_adjacent(hw_triangle(a), hw_triangle(other)) && !hw_is_adjacent(hw_triangle(a), "
        "hw_triangle(a - 10u));\n"
        "vec3 found = vec3(float(k / 2050u - 4092u), float(k % 2050u) / 10.0, right ? 255.0 : 0.0) / 255.0;\n"
        "hw_fragment = vec4(mix(found / 12.92, pow((found + 0.055) / 1.055, vec3(2.4)), step(0.04045, found)), 1.0);\n"
        "}\n");
    style.draws_lines = [&](Pass& pass, Items) {
        pass.cover(judge, Uniforms()
                              .set("ids", pass.image({"triangle_ids", {}}))
                              .set("triangle_corners", pass.image({"triangle_corners", {}})));
    };
    load(style);
    // The last four columns fill the picture.
    const Pixels picture = draw(view_from({4094, 2, 3.4641016}, {4094, 2, 0}, {256, 256}), {.samples = 1});
    int wrong = 0;
    for (int y = 2; y < 254; ++y)
        for (int x = 2; x < 254; ++x) {
            const std::uint8_t* found = picture.at(x, y);
            const bool is_right = found[0] == x / 64 && std::abs(10 * found[1] - (255 - y) * 8) < 40 && found[2] == 255;
            wrong += is_right || x % 64 == 0 || x % 64 == 63 ? 0 : 1;
        }
    EXPECT_EQ(wrong, 0);
}

TEST_F(triangle_ids, tables_are_looked_up_above_2_to_the_24)
{
    const std::uint32_t entry = 3u * (kAbove2To24 - 1u) + 2u;  // the last corner
    const Program judge = shaders_.full_screen(
        "#include \"full_screen.glsl\"\n#include \"triangle_ids.glsl\"\nvoid main() {\n"
        "bool holds = hw_table_texel(3u * (16777221u - 1u) + 2u) == ivec2(" +
        std::to_string(entry % kTriangleTableWidth) + ", " + std::to_string(entry / kTriangleTableWidth) +
        ");\nhw_fragment = vec4(0.0, holds ? 1.0 : 0.0, 0.0, 1.0); }\n");
    ScriptedStyle style;
    style.draws_lines = [&](Pass& pass, Items) { pass.cover(judge, {}); };
    load(style);
    EXPECT_EQ(draw(view_from({1, 1, 9}, {1, 1, 0}, kSize), {.samples = 1}).at(3, 3)[1], 255);
}

}  // namespace
}  // namespace hw::test
