#include <gmock/gmock.h>

#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/test_scenes.hpp"

namespace hw::test {
namespace {

constexpr glm::dmat4 kHere(1.0);

glm::dmat4 at(double x, double y, double z)
{
    return glm::translate(kHere, glm::dvec3(x, y, z));
}

LineLook look_of_width(float width_px)
{
    LineLook look;
    look.all({.width_px = width_px});
    look.far.is_on = false;
    return look;
}

class lines : public RendererTest {
 protected:
    lines() { style_.look = look_of_width(2.0f); }
    Pixels draw_with(LinePath path, const View& view, int samples = 4)
    {
        return draw(view, {.samples = samples, .line_path = path});
    }
    TestStyle style_{glm::vec3(1.0f)};
};

/// Ink of the picture, in pixels of full black: paper is white, colours are linear.
double ink(const Pixels& pixels)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < pixels.bytes.size(); i += 3) {
        const double c = pixels.bytes[i] / 255.0;
        sum += 1.0 - (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
    }
    return sum;
}

TEST_F(lines, of_a_box_seen_from_a_corner_are_its_nine_visible_edges)
{
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, painted(glm::vec3(1.0f)));
    load(style_);
    const View view = view_from({1.6, 1.4, 2.0}, {0, 0, 0});
    double length_px = 0.0;
    const glm::mat4 clip = view.clip_from_view * view.view_from_world;
    const auto screen = [&](glm::vec3 p) {
        const glm::vec4 q = clip * glm::vec4(p, 1.0f);
        return glm::vec2(q) / q.w * 0.5f * glm::vec2(view.size_px);
    };
    for (int axis = 0; axis < 3; ++axis)
        for (int corner = 0; corner < 4; ++corner) {
            glm::vec3 a(0.0f);
            a[axis] = -0.5f;
            a[(axis + 1) % 3] = corner & 1 ? 0.5f : -0.5f;
            a[(axis + 2) % 3] = corner & 2 ? 0.5f : -0.5f;
            glm::vec3 b = a;
            b[axis] = 0.5f;
            if (corner != 0) length_px += glm::distance(screen(a), screen(b));
        }
    for (const LinePath path : {LinePath::quads, LinePath::native}) {
        const Pixels pixels = draw_with(path, view);
        keep_picture(pixels, path == LinePath::quads ? "lines_box_quads" : "lines_box_native");
        EXPECT_NEAR(ink(pixels) / (2.0 * length_px), 1.0, 0.03);
        EXPECT_EQ(stats_.silhouette_extractions, 0) << "a box has no smooth edge";
    }
}

TEST_F(lines, both_ways_of_drawing_agree)
{
    add_object(scene_, sphere_mesh(1.0f, 20), kHere, painted(glm::vec3(1.0f)));
    add_object(scene_, box_mesh({3.0f, 0.2f, 3.0f}), at(0, -1.1, 0), painted(glm::vec3(1.0f)));
    load(style_);
    const View view = view_from({1.5, 1.0, 3.5}, {0, 0, 0});
    const Pixels quads = draw_with(LinePath::quads, view);
    const Pixels native = draw_with(LinePath::native, view);
    keep_picture(quads, "lines_scene_quads");
    keep_picture(native, "lines_scene_native");
    EXPECT_NEAR(ink(quads) / ink(native), 1.0, 0.08);
    EXPECT_LT(count_unlike(quads, native, 128), count_dark(quads) / 20);
}

TEST_F(lines, of_a_sphere_are_its_silhouette_alone)
{
    add_object(scene_, sphere_mesh(1.0f, 32), kHere, painted(glm::vec3(1.0f)));
    load(style_);
    const Pixels pixels = draw_with(LinePath::quads, view_from({0, 0, 4}, {0, 0, 0}));
    keep_picture(pixels, "lines_sphere");
    EXPECT_EQ(stats_.silhouette_extractions, 1);
    EXPECT_GT(stats_.silhouette_edges, 30u);
    for (int x = 120; x < 200; x += 10) EXPECT_EQ(pixels.at(x, 120)[0], 255) << "no line inside";
}

TEST_F(lines, behind_a_nearer_face_are_hidden)
{
    add_object(scene_, box_mesh(glm::vec3(0.5f)), at(0, 0, -1), painted(glm::vec3(1.0f)));
    add_object(scene_, box_mesh({4.0f, 4.0f, 0.1f}), at(0, 0, 0), painted(glm::vec3(1.0f)));
    load(style_);
    const Pixels pixels = draw_with(LinePath::quads, view_from({0, 0, 3}, {0, 0, 0}));
    for (int y = 60; y < 180; ++y)
        for (int x = 80; x < 240; ++x) ASSERT_EQ(pixels.at(x, y)[0], 255) << x << ' ' << y;
}

TEST_F(lines, of_faces_that_look_away_are_there_where_both_sides_are_seen)
{
    Material walls = painted(glm::vec3(1.0f));
    for (const bool is_double_sided : {true, false}) {
        walls.is_double_sided = is_double_sided;
        scene_ = {};
        add_object(scene_, box_mesh(glm::vec3(4.0f)), kHere, walls);
        load(style_);
        const int dark = count_dark(draw_with(LinePath::quads, view_from({0, 0, 0}, {1, 0.2, 1})));
        EXPECT_EQ(dark > 100, is_double_sided) << dark;
        EXPECT_EQ(dark == 0, !is_double_sided);
    }
}

// The box's own face goes on below the slab, half a pixel from the fold: it tells nothing of what hides the fold.
TEST_F(lines, of_a_fold_that_is_hidden_beside_its_own_face_stay_hidden)
{
    TestStyle bare{glm::vec3(1.0f)};
    const View view = view_from({0, 0, 6}, {0, 0, 0});
    const glm::mat4 clip = view.clip_from_view * view.view_from_world;
    const auto px_per_m = [&](float z) {
        return clip[1][1] / (clip * glm::vec4(0, 0, z, 1)).w * 0.5f * static_cast<float>(view.size_px.y);
    };
    constexpr float kBoxFront = 0.1f, kSlabBack = 0.9f;  // from below its back edge is the lower one
    for (int k = 0; k < 10; ++k) {
        const float fold_px = 50.0f + 0.1f * static_cast<float>(k);  // above the middle; the top looks away
        const float top = fold_px / px_per_m(kBoxFront), bottom = (fold_px - 0.6f) / px_per_m(kSlabBack);
        scene_ = {};
        add_object(scene_, box_mesh({2.0f, 2.0f * top, 0.2f}), kHere, painted(glm::vec3(1.0f)));
        add_object(scene_, box_mesh({4.0f, 1.0f, 0.2f}), at(0, bottom + 0.5, 1), painted(glm::vec3(1.0f)));
        load({{"lines", &style_}, {"bare", &bare}}, {{.style = 0}, {.style = 1}});
        const Pixels pixels = draw(view, {.samples = 1});
        EXPECT_GT(count_dark(pixels), 100) << "the sides";
        for (int y = 120 - 53; y < 120 - 46; ++y)
            for (int x = 140; x < 180; ++x) ASSERT_EQ(pixels.at(x, y)[0], 255) << x << ' ' << y << " at " << fold_px;
    }
}

TEST_F(lines, a_sheet_of_paper_on_a_desk_keeps_its_outline_and_hides_the_desk)
{
    add_object(scene_, box_mesh({2.0f, 0.05f, 1.0f}), kHere, painted(glm::vec3(0.6f)));
    MeshData paper = floor_mesh(0.3f);
    add_object(scene_, paper, at(0, 0.025 + 0.0005, 0), painted(glm::vec3(1.0f)));
    load(style_);
    const Pixels pixels = draw_with(LinePath::quads, view_from({0.0, 0.6, 0.9}, {0, 0, 0}, {640, 480}));
    keep_picture(pixels, "lines_paper_on_desk");
    EXPECT_EQ(pixels.at(320, 240)[0], 255) << "the paper covers the desk";
    EXPECT_GT(count_dark(pixels), 900);
}

TEST_F(lines, leave_faces_at_their_own_depth)
{
    // Red walls end a tenth of a millimetre below a floor that is seen at a grazing angle.
    add_object(scene_, floor_mesh(20.0f), kHere, painted(glm::vec3(1.0f)));
    for (int i = 0; i < 8; ++i)
        add_object(scene_, box_mesh({20.0f, 0.5f, 0.2f}), at(0, -0.2501, 8.0 - 2.0 * i), painted({1.0f, 0.0f, 0.0f}));
    load(style_);
    for (const int samples : {1, 4}) {
        const Pixels pixels = draw_with(LinePath::quads, view_from({0, 0.4, 9.5}, {0, 0, -4}), samples);
        keep_picture(pixels, "lines_floor_over_walls");
        int red = 0;
        for (int y = 125; y < pixels.height; ++y)
            for (int x = 0; x < pixels.width; ++x) red += pixels.at(x, y)[0] > pixels.at(x, y)[1] + 40 ? 1 : 0;
        EXPECT_EQ(red, 0) << "no wall shines through the floor";
    }
}

TEST_F(lines, of_one_style_lie_on_the_faces_of_another)
{
    add_object(scene_, floor_mesh(4.0f), kHere, painted(glm::vec3(1.0f)));
    add_object(scene_, floor_mesh(1.0f), kHere, painted(glm::vec3(1.0f)));
    TestStyle plain(glm::vec3(1.0f));
    load({{"plain", &plain}, {"lined", &style_}}, {{.style = 0}, {.style = 1}});
    const View view = view_from({0, 1.0, 1.6}, {0, 0, 0});
    const double on_the_floor = ink(draw_with(LinePath::quads, view));
    scene_.objects.erase(scene_.objects.begin());
    load({{"plain", &plain}, {"lined", &style_}}, {{.style = 1}});
    const double alone = ink(draw_with(LinePath::quads, view));
    EXPECT_GT(alone, 300.0);
    EXPECT_NEAR(on_the_floor / alone, 1.0, 0.05) << "no half of the outline sinks into the floor";
}

TEST_F(lines, crossing_the_near_plane_run_on_to_the_edge_of_the_picture)
{
    add_object(scene_, box_mesh({0.4f, 0.4f, 40.0f}), at(0, -0.6, 0), painted(glm::vec3(1.0f)));
    load(style_);
    const View view = view_from({0, 0, 0}, {0, -0.05, -5});
    for (const LinePath path : {LinePath::quads, LinePath::native}) {
        const Pixels pixels = draw_with(path, view);
        keep_picture(pixels, path == LinePath::quads ? "lines_near_quads" : "lines_near_native");
        int dark_at_the_bottom = 0;
        for (int x = 0; x < 320; ++x) dark_at_the_bottom += pixels.at(x, 238)[0] < 200 ? 1 : 0;
        EXPECT_GE(dark_at_the_bottom, 4) << "two lines leave at the bottom";
        EXPECT_LE(dark_at_the_bottom, 14);
    }
}

/// Upright bars, 4 cm from one to the next.
MeshData comb_mesh(int teeth, float height)
{
    MeshData comb = box_mesh({0.02f, height, 0.02f});
    const MeshData tooth = comb;
    for (int i = 1; i < teeth; ++i) {
        const auto first = static_cast<std::uint32_t>(comb.positions.size());
        for (const glm::vec3& p : tooth.positions)
            comb.positions.push_back(p + glm::vec3(0.04f * static_cast<float>(i), 0.0f, 0.0f));
        comb.normals.insert(comb.normals.end(), tooth.normals.begin(), tooth.normals.end());
        for (const std::uint32_t index : tooth.indices) comb.indices.push_back(first + index);
    }
    return comb;
}

TEST_F(lines, of_near_objects_are_drawn_in_full_by_the_far_policy)
{
    struct Case {
        MeshData mesh;
        View view;
    };
    const Case cases[]{{box_mesh(glm::vec3(1.0f)), view_from({1.6, 1.4, 2.0}, {0, 0, 0})},
                       {comb_mesh(60, 0.2f), view_from({1.2, 0.1, 0.35}, {1.2, 0, 0})}};
    for (const Case& c : cases) {
        scene_ = {};
        add_object(scene_, c.mesh, kHere, painted(glm::vec3(1.0f)));
        style_.look->far.is_on = false;
        load(style_);
        const double all_of_it = ink(draw_with(LinePath::quads, c.view));
        style_.look->far = {.full_spacing_px = 6.0f};
        load(style_);
        EXPECT_NEAR(ink(draw_with(LinePath::quads, c.view)) / all_of_it, 1.0, 0.02) << c.mesh.positions.size();
    }
}

TEST_F(lines, far_objects_do_not_turn_black)
{
    add_object(scene_, comb_mesh(60, 1.0f), kHere, painted(glm::vec3(1.0f)));
    style_.look->far = {.full_spacing_px = 6.0f};
    load(style_);
    // Lines of 2 px that never come closer than 6 px cover a third.
    for (const double z : {4.0, 10.0, 25.0, 60.0}) {
        const double tone = ink(draw_with(LinePath::quads, view_from({1.2, 0, z}, {1.2, 0, 0})));
        const double px_per_m = 120.0 / std::tan(0.5236) / z;
        EXPECT_LT(tone / ((2.38 * px_per_m + 2.0) * (1.0 * px_per_m + 2.0)), 0.45) << z;
        EXPECT_GT(tone, 1.0) << z << ": it does not vanish";
    }
}

TEST_F(lines, fade_with_the_distance_without_a_step)
{
    for (const MeshData& mesh : {box_mesh(glm::vec3(1.0f)), comb_mesh(60, 1.0f)}) {
        scene_ = {};
        add_object(scene_, mesh, kHere, painted(glm::vec3(1.0f)));
        style_.look->far = {.full_spacing_px = 6.0f};
        load(style_);
        double before = 0.0;
        for (double z = 4.0; z < 60.0; z *= 1.03) {
            const double now = ink(draw_with(LinePath::quads, view_from({0.61 * z, 0.43 * z, z}, {0, 0, 0})));
            if (before > 0.0) {
                EXPECT_LT(std::abs(now / before - 1.0), 0.15) << mesh.positions.size() << " at " << z;
            }
            before = now;
        }
    }
}

TEST_F(lines, inside_of_a_far_object_go_before_its_outline)
{
    // A tile with a grid of grooves on its front: the rim is an outline, the grooves are not.
    MeshData tile;
    constexpr int kGrooves = 24;
    for (int i = 0; i <= kGrooves; ++i)
        for (int k = 0; k <= 1; ++k)
            tile.positions.emplace_back(2.0f * i / kGrooves - 1.0f, k - 0.5f, i % 2 ? 0.03f : 0.0f);
    for (std::uint32_t i = 0; i < kGrooves; ++i) {
        const std::uint32_t at = 2 * i;
        for (const std::uint32_t corner : {at, at + 2, at + 1, at + 1, at + 2, at + 3}) tile.indices.push_back(corner);
    }
    tile.normals.assign(tile.positions.size(), glm::vec3(0, 0, 1));
    add_object(scene_, tile, kHere, painted(glm::vec3(1.0f)));
    style_.crease_rad = 0.3f;
    style_.look->far = {.full_spacing_px = 6.0f};
    load(style_);
    const Pixels far = draw_with(LinePath::quads, view_from({0, 0, 16}, {0, 0, 0}));
    keep_picture(far, "lines_far_tile");
    // Of 26 x 13 px: in the middle of it is no ink, around it is.
    double inside = 0.0;
    for (int x = 153; x < 167; ++x) inside += 1.0 - std::pow(far.at(x, 120)[0] / 255.0, 2.2);
    EXPECT_LT(inside / 14.0, 0.04);
    EXPECT_GT(ink(far), 4.0);
}

TEST_F(lines, in_many_pieces_add_up_to_the_line_when_they_are_light)
{
    // One long bar, whole and in 400 slices.
    const auto bar = [](int slices) {
        MeshData mesh;
        for (int i = 0; i <= slices; ++i)
            for (int k = 0; k <= 1; ++k)
                mesh.positions.emplace_back(2.0f * static_cast<float>(i) / static_cast<float>(slices) - 1.0f,
                                            0.4f * static_cast<float>(k), 0.0f);
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(slices); ++i) {
            const std::uint32_t at = 2 * i;
            for (const std::uint32_t corner : {at, at + 2, at + 1, at + 1, at + 2, at + 3})
                mesh.indices.push_back(corner);
        }
        mesh.normals.assign(mesh.positions.size(), glm::vec3(0, 0, 1));
        return mesh;
    };
    style_.look->all({.width_px = 0.3f});
    const View view = view_from({0.1, 0.3, 2.6}, {0.05, 0.2, 0});
    for (const int samples : {1, 4}) {
        scene_ = {};
        add_object(scene_, bar(1), kHere, painted(glm::vec3(1.0f)));
        load(style_);
        const double whole = ink(draw_with(LinePath::quads, view, samples));
        scene_ = {};
        add_object(scene_, bar(400), kHere, painted(glm::vec3(1.0f)));
        load(style_);
        EXPECT_NEAR(ink(draw_with(LinePath::quads, view, samples)) / whole, 1.0, 0.08) << samples;
    }
}

TEST_F(lines, presence_thins_them)
{
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, painted(glm::vec3(1.0f)));
    TestStyle without_lines(glm::vec3(1.0f));
    const View view = view_from({1.6, 1.4, 2.0}, {0, 0, 0});
    load(style_);
    const double full = ink(draw_with(LinePath::quads, view));
    StyledObject look{.style = 0, .over = 1, .presence = {.constant = 0.75f}};
    load({{"ink", &style_}, {"plain", &without_lines}}, {look});
    EXPECT_NEAR(ink(draw_with(LinePath::quads, view)) / full, 0.25, 0.06) << "the base keeps what the other leaves";
    std::swap(look.style, look.over);
    load({{"ink", &style_}, {"plain", &without_lines}}, {look});
    EXPECT_NEAR(ink(draw_with(LinePath::quads, view)) / full, 0.75, 0.06);
    EXPECT_NEAR(ink(draw_with(LinePath::native, view)) / full, 0.75, 0.10);
}

TEST_F(lines, a_taper_thins_the_far_ones)
{
    for (const double z : {-2.0, -40.0})
        add_object(scene_, box_mesh(glm::vec3(1.0f)), at(0, 0, z), painted(glm::vec3(1.0f)));
    style_.look->depth_taper = 1.0f;
    style_.look->taper_from_m = 5.0f;
    load(style_);
    draw(view_from({0, 2, 3}, {0, 0, -10}), {.samples = 4});
    EXPECT_GT(stats_.lines, 0u);
    const std::uint64_t as_quads = stats_.triangles;
    draw(view_from({0, 2, 3}, {0, 0, -10}), {.samples = 4, .line_path = LinePath::native});
    EXPECT_EQ(stats_.triangles, as_quads) << "a taper needs quads";
}

TEST_F(lines, are_counted_alike_by_either_path)
{
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, painted(glm::vec3(1.0f)));
    load(style_);
    std::vector<FrameStats> both;
    for (const LinePath path : {LinePath::quads, LinePath::native}) {
        draw(view_from({2, 3, 4}, {0, 0, 0}), {.samples = 4, .line_path = path});
        both.push_back(stats_);
    }
    EXPECT_EQ(both[0].lines, 12u) << "a box has twelve creases";
    EXPECT_EQ(both[1].lines, 12u);
    EXPECT_GT(both[0].triangles, both[1].triangles) << "quads are triangles, too";
}

TEST_F(lines, a_larger_crease_angle_draws_fewer)
{
    add_object(scene_, sphere_mesh(1.0f, 6), kHere, painted(glm::vec3(1.0f)));
    style_.crease_rad = 0.1f;
    load(style_);
    const View view = view_from({0, 1, 4}, {0, 0, 0});
    const double many = ink(draw_with(LinePath::quads, view));
    style_.crease_rad = 1.5f;
    load(style_);
    EXPECT_LT(ink(draw_with(LinePath::quads, view)), 0.7 * many);
}

TEST_F(lines, of_a_style_whose_needs_name_no_edges_are_not_drawn)
{
    struct NeedsNothing final : Style {
        Needs needs() const override { return {}; }
        void prepare(ProgramCache&) override {}
        void lines(Pass& pass, Items items) override { pass.lines(LineLook(), items); }
    };
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, painted(glm::vec3(1.0f)));
    NeedsNothing over;
    TestStyle paper(glm::vec3(1.0f));
    paper.look = look_of_width(0.0f);  // builds the edges and draws none
    load({{"paper", &paper}, {"over", &over}}, {{.style = 0, .over = 1}});
    EXPECT_EQ(ink(draw_with(LinePath::quads, view_from({0, 1, 4}, {0, 0, 0}))), 0.0);
}

TEST_F(lines, have_the_share_of_their_look_times_the_presence_of_the_level)
{
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, painted(glm::vec3(1.0f)));
    TestStyle paper(glm::vec3(1.0f));
    const auto drawn = [&](PresenceField share, PresenceField presence) {
        style_.look->share = share;
        load({{"paper", &paper}, {"ink", &style_}}, {{.style = 0, .over = 1, .presence = presence}});
        return ink(draw_with(LinePath::quads, view_from({0, 1, 4}, {0, 0, 0})));
    };
    const double whole = drawn({}, {});
    EXPECT_NEAR(drawn({.constant = 0.5f}, {}) / whole, 0.5, 0.05);
    EXPECT_NEAR(drawn({.constant = 0.5f}, {.constant = 0.5f}) / whole, 0.25, 0.05);
    const double lower_half = drawn({.height = Ramp{0.1f, -0.1f}}, {});
    EXPECT_LT(lower_half, 0.7 * whole);
    EXPECT_NEAR(drawn({.height = Ramp{0.1f, -0.1f}}, {.constant = 0.5f}) / lower_half, 0.5, 0.05)
        << "a ramp of the style does not take the level's place";
}

TEST_F(lines, adjacency_is_built_once_for_instances_and_for_ink_alone)
{
    const ObjectId first = add_object(scene_, sphere_mesh(1.0f, 8), kHere, painted(glm::vec3(1.0f)));
    Object twin = scene_.objects[first];
    Node node;
    node.world_from_node = at(3, 0, 0);
    twin.node = 1;
    scene_.nodes.push_back(node);
    scene_.objects.push_back(twin);
    add_object(scene_, sphere_mesh(1.0f, 8), at(-3, 0, 0), painted(glm::vec3(1.0f)));
    TestStyle photoreal(glm::vec3(0.5f));
    const StyledObject inked{.style = 0};
    const StyledObject plain{.style = 1};
    load({{"ink", &style_}, {"plain", &photoreal}}, {inked, inked, plain});
    draw(view_from({0, 0, 8}, {0, 0, 0}));
    EXPECT_EQ(stats_.adjacencies_built, 1);
    EXPECT_EQ(stats_.edge_tables_built, 1);
    EXPECT_EQ(stats_.silhouette_extractions, 2);
}

TEST_F(lines, at_the_foot_of_a_wall_have_all_their_width)
{
    add_object(scene_, floor_mesh(20.0f), kHere, painted(glm::vec3(1.0f)));
    add_object(scene_, box_mesh({1.0f, 2.0f, 1.0f}), at(0, 1, 0), painted(glm::vec3(1.0f)));
    load(style_);
    const Pixels pixels = draw_with(LinePath::quads, view_from({0, 0.6, 4}, {0, 0.5, 0}));
    keep_picture(pixels, "lines_foot");
    // Down a column through the middle of the front: its foot is the lowest ink, and two pixels of it.
    double foot = 0.0;
    for (int y = 130; y < 200; ++y) foot += 1.0 - std::pow(pixels.at(160, y)[0] / 255.0, 2.2);
    EXPECT_NEAR(foot, 2.0, 0.05) << "half of it lies on the floor, which comes nearer";
}

TEST_F(lines, where_objects_go_through_each_other_are_drawn_when_asked_for)
{
    add_object(scene_, floor_mesh(4.0f), kHere, painted(glm::vec3(1.0f)));
    add_object(scene_, box_mesh(glm::vec3(1.0f)), at(0, 0.2, 0), painted(glm::vec3(1.0f)));
    load(style_);
    const View view = view_from({0, 6, 0.01}, {0, 0, 0});
    const View aslant = view_from({0, 1.5, 4}, {0, 0, 0});
    const double without = ink(draw_with(LinePath::quads, aslant));
    style_.intersections = true;
    load(style_);
    const Pixels pixels = draw_with(LinePath::quads, aslant);
    keep_picture(pixels, "lines_intersection");
    // The front foot: a metre at 3.5 m, along the picture.
    const double foot_px = glm::distance(glm::vec2(-0.5f), glm::vec2(0.5f, -0.5f)) * 120.0 / std::tan(0.5236) / 3.76;
    EXPECT_NEAR(ink(pixels) - without, 2.0 * foot_px, 0.1 * foot_px);
    draw_with(LinePath::quads, view);
    EXPECT_GT(stats_.triangles, 0u);
}

TEST_F(lines, by_hand_stay_where_they_are_whatever_was_drawn_before)
{
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, painted(glm::vec3(1.0f)));
    add_object(scene_, sphere_mesh(0.4f, 16), at(0.9, 0, 0), painted(glm::vec3(1.0f)));
    const View view = view_from({1.6, 1.4, 2.0}, {0.3, 0, 0});
    load(style_);
    const Pixels ruled = draw_with(LinePath::quads, view);
    style_.look->stroke = {.wobble_px = 2.0f, .overshoot_px = 8.0f, .taper_px = 10.0f};
    load(style_);
    const Pixels first = draw_with(LinePath::quads, view);
    keep_picture(first, "lines_by_hand");
    EXPECT_GT(count_unlike(ruled, first, 64), 200) << "they stray";
    draw_with(LinePath::quads, view_from({-1.6, 0.4, 2.5}, {0.3, 0, 0}));
    EXPECT_EQ(count_unlike(first, draw_with(LinePath::quads, view)), 0);
    EXPECT_NEAR(ink(first) / ink(ruled), 1.0, 0.25);
}

TEST_F(lines, by_hand_do_not_slide_over_the_object_when_the_eye_turns)
{
    add_object(scene_, box_mesh({3.0f, 0.5f, 0.5f}), kHere, painted(glm::vec3(1.0f)));
    style_.look->stroke = {.dash_px = 24.0f, .dash_share = 0.5f};
    load(style_);
    // The eye moves sideways by so much that the picture of the front moves by whole pixels.
    const double metres_per_px = 4.0 * std::tan(0.5236) / 120.0;
    const Pixels here = draw_with(LinePath::quads, view_from({0, 0, 4.25}, {0, 0, 0}));
    const double shift = 10 * metres_per_px;
    const Pixels there = draw_with(LinePath::quads, view_from({shift, 0, 4.25}, {shift, 0, 0}));
    int unlike = 0;
    for (int y = 0; y < 240; ++y)
        for (int x = 20; x < 300; ++x) unlike += std::abs(here.at(x, y)[0] - there.at(x - 10, y)[0]) > 48 ? 1 : 0;
    EXPECT_GT(count_dark(here), 100);
    EXPECT_LT(unlike, 12);
}

TEST_F(lines, that_are_dashed_have_the_share_of_their_dashes_and_silhouettes_are_whole)
{
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, painted(glm::vec3(1.0f)));
    const View view = view_from({1.6, 1.4, 2.0}, {0, 0, 0});
    load(style_);
    const double whole = ink(draw_with(LinePath::quads, view));
    style_.look->stroke = {.dash_px = 12.0f, .dash_share = 0.5f};
    load(style_);
    EXPECT_NEAR(ink(draw_with(LinePath::quads, view)) / whole, 0.5, 0.06);
    scene_ = {};
    add_object(scene_, sphere_mesh(1.0f, 32), kHere, painted(glm::vec3(1.0f)));
    load(style_);
    const double dashed_sphere = ink(draw_with(LinePath::quads, view_from({0, 0, 4}, {0, 0, 0})));
    style_.look->stroke = {};
    load(style_);
    EXPECT_NEAR(dashed_sphere / ink(draw_with(LinePath::quads, view_from({0, 0, 4}, {0, 0, 0}))), 1.0, 0.01);
}

TEST_F(lines, of_a_lesser_fold_are_thinner_when_folds_count)
{
    add_object(scene_, sphere_mesh(1.0f, 5), kHere, painted(glm::vec3(1.0f)));  // folds of 36 degrees
    style_.crease_rad = 0.3f;
    const View view = view_from({0, 1, 4}, {0, 0, 0});
    load(style_);
    const double even = ink(draw_with(LinePath::quads, view));
    style_.look->fold_weight = 1.0f;
    load(style_);
    EXPECT_LT(ink(draw_with(LinePath::quads, view)), 0.75 * even);
    scene_ = {};
    add_object(scene_, box_mesh(glm::vec3(1.0f)), kHere, painted(glm::vec3(1.0f)));
    load(style_);
    const double right_angles = ink(draw_with(LinePath::quads, view));
    style_.look->fold_weight = 0.0f;
    load(style_);
    EXPECT_NEAR(right_angles / ink(draw_with(LinePath::quads, view)), 1.0, 0.01);
}

}  // namespace
}  // namespace hw::test
