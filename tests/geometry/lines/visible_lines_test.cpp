#include "hatchway/geometry/lines/visible_lines.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "hatchway/geometry/lines/intersections.hpp"
#include "hatchway/geometry/lines/line_chains.hpp"
#include "tests/geometry/test_meshes.hpp"

namespace {

using namespace hw::test;
using Class = hw::LineClass;

const hw::LineCamera kFront{.eye_world = {0, 0, 10}, .target_world = {0, 0, 0}, .size_px = {800, 600}};

/// Pixels of a point as kFront sees it.
glm::dvec2 pixel(const glm::dvec3& p)
{
    const double focal = 300.0 / std::tan(0.5 * kFront.fov_rad);
    return {400.0 + focal * p.x / (10.0 - p.z), 300.0 - focal * p.y / (10.0 - p.z)};
}

double length_of(const hw::VisibleLine& line)
{
    double sum = 0.0;
    for (std::size_t i = 1; i < line.points_px.size(); ++i)
        sum += glm::distance(line.points_px[i - 1], line.points_px[i]);
    return line.is_closed ? sum + glm::distance(line.points_px.back(), line.points_px.front()) : sum;
}

double total(const std::vector<hw::VisibleLine>& lines, bool is_visible, std::uint32_t object)
{
    double sum = 0.0;
    for (const hw::VisibleLine& line : lines) {
        if (line.is_visible == is_visible && line.object == object) sum += length_of(line);
    }
    return sum;
}

hw::Surface upright_square()
{
    hw::MeshData mesh = mesh_of({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {0, 1, 2, 0, 2, 3});
    return hw::build_surface(mesh);
}

glm::dmat4 at(double x, double y, double z)
{
    return glm::translate(glm::dmat4(1.0), glm::dvec3(x, y, z));
}

}  // namespace

TEST(visible_lines, a_square_is_one_closed_line_where_the_camera_sees_it)
{
    const hw::Surface square = upright_square();
    const std::vector<hw::LineObject> objects{{&square}};
    const auto lines = hw::find_visible_lines(objects, kFront);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].line_class, Class::border);
    EXPECT_TRUE(lines[0].is_closed);
    ASSERT_EQ(lines[0].points_px.size(), 4u);
    for (const glm::dvec3& corner : {glm::dvec3(-1, -1, 0), glm::dvec3(1, -1, 0), glm::dvec3(1, 1, 0)}) {
        const bool is_there = std::any_of(lines[0].points_px.begin(), lines[0].points_px.end(),
                                          [&](const auto& p) { return glm::distance(p, pixel(corner)) < 1e-9; });
        EXPECT_TRUE(is_there);
    }
}

TEST(visible_lines, of_shells_that_lie_on_each_other_are_drawn_once)
{
    const hw::MeshData ball = sphere(16, 12);
    const hw::Surface front_surface = hw::build_surface(ball), back_surface = hw::build_surface(turned_over(ball));
    const std::vector<hw::LineObject> one{{&front_surface}};
    const std::vector<hw::LineObject> both{{&front_surface}, {&back_surface}, {&front_surface, at(2.5, 0.0, 0.0)}};
    const double alone = total(hw::find_visible_lines(one, kFront), true, 0);
    const auto lines = hw::find_visible_lines(both, kFront);
    EXPECT_GT(alone, 100.0);
    EXPECT_NEAR(total(lines, true, 0), alone, 1e-6 * alone);
    EXPECT_EQ(total(lines, true, 1), 0.0) << "the first shell keeps the lines";
    EXPECT_GT(total(lines, true, 2), 0.9 * alone) << "a ball beside has its own";

    const hw::Surface doubled = hw::build_surface(joined({ball, ball}));
    EXPECT_NEAR(total(hw::find_visible_lines(std::vector<hw::LineObject>{{&doubled}}, kFront), true, 0), alone,
                1e-6 * alone);
}

TEST(visible_lines, a_square_hides_the_part_of_another_that_is_behind_it)
{
    const hw::Surface square = upright_square();
    const std::vector<hw::LineObject> objects{{&square}, {&square, at(1.0, 0.0, -2.0)}};
    const auto lines = hw::find_visible_lines(objects, kFront, {.with_hidden = true});
    // The left border of the far square is hidden whole, and the level borders as far as the near square's right side.
    const double hidden = pixel({1, 0, 0}).x - pixel({0, 0, -2}).x;
    const double height = pixel({0, -1, -2}).y - pixel({0, 1, -2}).y;
    EXPECT_NEAR(total(lines, false, 1), height + 2.0 * hidden, 1e-6);
    EXPECT_NEAR(total(lines, false, 0), 0.0, 0.0);
    const double width = pixel({2, 0, -2}).x - pixel({0, 0, -2}).x;
    EXPECT_NEAR(total(lines, true, 1), height + 2.0 * (width - hidden), 1e-6);
}

TEST(visible_lines, hidden_parts_are_left_out_unless_asked_for)
{
    const hw::Surface square = upright_square();
    const std::vector<hw::LineObject> objects{{&square}, {&square, at(0.0, 0.0, -2.0)}};
    EXPECT_EQ(total(hw::find_visible_lines(objects, kFront), false, 1), 0.0);
    EXPECT_EQ(total(hw::find_visible_lines(objects, kFront), true, 1), 0.0);
}

TEST(visible_lines, a_line_through_a_face_is_cut_where_it_goes_through)
{
    const hw::Surface square = upright_square();
    const glm::dmat4 crossing = glm::rotate(at(0, 0, 0), 0.5 * 3.141592653589793, glm::dvec3(1, 0, 0));
    const std::vector<hw::LineObject> objects{{&square}, {&square, glm::scale(crossing, glm::dvec3(0.5, 0.5, 0.5))}};
    // The second square lies level and half of it is behind the first; both its sides that go backward are cut at z =
    // 0.
    const auto raised = hw::LineCamera{.eye_world = {0, 3, 10}, .target_world = {0, 0, 0}, .size_px = {800, 600}};
    const auto lines = hw::find_visible_lines(objects, raised, {.with_hidden = true});
    int cut_ends = 0;
    for (const hw::VisibleLine& line : lines) {
        if (line.object == 1 && line.is_visible && !line.is_closed) cut_ends += 2;
    }
    EXPECT_EQ(cut_ends, 2);
    EXPECT_GT(total(lines, false, 1), 10.0);
}

TEST(visible_lines, lines_on_a_coplanar_neighbour_stay_visible)
{
    const hw::Surface square = upright_square();
    const std::vector<hw::LineObject> objects{{&square}, {&square, glm::scale(at(0, 0, 0), glm::dvec3(0.5))}};
    const auto lines = hw::find_visible_lines(objects, kFront, {.with_hidden = true});
    EXPECT_EQ(total(lines, false, 1), 0.0);
}

TEST(visible_lines, opposite_flaps_and_duplicated_triangles_hide_nothing_of_themselves)
{
    const hw::MeshData front = mesh_of({{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {0, 1, 2});
    const hw::Surface flaps = hw::build_surface(joined({front, turned_over(front)}));
    const hw::Surface twice = hw::build_surface(joined({front, front}));
    for (const hw::Surface* surface : {&flaps, &twice}) {
        const std::vector<hw::LineObject> objects{{surface}};
        const auto lines = hw::find_visible_lines(objects, kFront, {.with_hidden = true});
        EXPECT_EQ(total(lines, false, 0), 0.0);
        EXPECT_GT(total(lines, true, 0), 100.0);
    }
}

/// A triangle and what lies exactly in its plane, turned so that no coordinate is round, at an offset and a scale.
hw::Surface turned(const hw::MeshData& mesh, float offset, float scale)
{
    glm::mat4 place = glm::translate(glm::mat4(1.0f), glm::vec3(offset));
    place = glm::rotate(place, 0.9f, glm::vec3(0.3f, 0.8f, 0.2f));
    return hw::build_surface(moved(mesh, glm::scale(place, glm::vec3(scale))));
}

hw::LineCamera camera_at(float offset, float scale)
{
    const glm::dvec3 centre(offset);
    return {.eye_world = centre + glm::dvec3(2.1, 1.3, 4.7) * static_cast<double>(scale),
            .target_world = centre,
            .size_px = {800, 600},
            .near_m = 1e-3 * scale};
}

TEST(visible_lines, flaps_and_doubles_hide_nothing_at_any_offset_and_scale)
{
    const hw::MeshData front = mesh_of({{-1, -1, 0}, {1, -0.9f, 0.1f}, {0.1f, 1, 0.3f}}, {0, 1, 2});
    for (const hw::MeshData& mesh :
         {joined({front, turned_over(front)}), joined({front, front}), joined({front, turned_over(front), front})}) {
        for (const auto& [offset, scale] :
             {std::pair{0.0f, 1.0f}, {0.0f, 1e-6f}, {0.0f, 1e6f}, {1e3f, 1.0f}, {1e5f, 1e3f}, {1e6f, 1e4f}}) {
            const hw::Surface surface = turned(mesh, offset, scale);
            const std::vector<hw::LineObject> objects{{&surface}};
            const auto lines = hw::find_visible_lines(objects, camera_at(offset, scale), {.with_hidden = true});
            EXPECT_EQ(total(lines, false, 0), 0.0) << offset << " " << scale;
            EXPECT_GT(total(lines, true, 0), 100.0) << offset << " " << scale;
        }
    }
}

TEST(visible_lines, within_a_component_the_smallest_step_behind_a_face_is_hidden)
{
    // A sheet is folded back on itself: what lies behind is one unit in the last place away, and no tolerance could
    // tell that from what lies in the plane.
    const float behind = std::nextafter(5.0f, 0.0f);
    const hw::LineCamera camera{.eye_world = {0.3, 0.2, 20}, .target_world = {0, 0, 5}, .size_px = {800, 600}};
    const auto hidden = [&](float z) {
        const hw::MeshData folded =
            mesh_of({{-2, -2, 5}, {2, -2, 5}, {2, 2, 5}, {-2, 2, 5}, {-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}},
                    {0, 1, 2, 0, 2, 3, 1, 0, 4, 1, 4, 5, 5, 4, 7, 5, 7, 6});
        const hw::Surface surface = hw::build_surface(folded, {.stitch_share = 0.0f});
        EXPECT_EQ(surface.components.size(), 1u);
        const std::vector<hw::LineObject> objects{{&surface}};
        return total(hw::find_visible_lines(objects, camera, {.with_hidden = true}), false, 0);
    };
    EXPECT_EQ(hidden(5.0f), 0.0);
    EXPECT_GT(hidden(behind), 200.0);
}

/// A floor and an upright wall of 2 m on it, with its foot so far below.
hw::MeshData floor_of(float size)
{
    return mesh_of({{-size, 0, -size}, {-size, 0, size}, {size, 0, size}, {size, 0, -size}}, {0, 1, 2, 0, 2, 3});
}
hw::MeshData wall_sunk_by(float depth)
{
    return mesh_of({{-1, -depth, 0}, {1, -depth, 0}, {1, 1, 0}, {-1, 1, 0}}, {0, 1, 2, 0, 2, 3});
}

TEST(visible_lines, the_foot_of_a_wall_that_is_set_into_the_floor_by_a_rounding_is_visible)
{
    // As kits have it: the foot lies a few units in the last place too low, and no line where both meet is found for
    // it, since contact is none. A foot that is sunk in earnest is hidden.
    for (const double scale : {1e-3, 1.0, 1e3})
        for (const glm::dvec3& eye : {glm::dvec3(3, 2.5, 4), glm::dvec3(0.5, 0.02, 6), glm::dvec3(30, 8, 90)}) {
            const hw::LineCamera camera{
                .eye_world = eye * scale, .target_world = {0, 0, 0}, .size_px = {800, 600}, .near_m = 1e-3 * scale};
            const auto hidden = [&](float depth, bool is_one_object) {
                const hw::MeshData floor = floor_of(3.0f), wall = wall_sunk_by(depth);
                const hw::Surface both = hw::build_surface(joined({floor, wall}));
                const hw::Surface apart[] = {hw::build_surface(floor), hw::build_surface(wall)};
                const glm::dmat4 place = glm::scale(glm::dmat4(1.0), glm::dvec3(scale));
                std::vector<hw::LineObject> objects{{&both, place}};
                if (!is_one_object) objects = {{&apart[0], place}, {&apart[1], place}};
                const auto lines = hw::find_visible_lines(objects, camera, {.with_hidden = true});
                return total(lines, false, 0) + total(lines, false, 1);
            };
            for (const bool is_one_object : {true, false}) {
                const double none = hidden(0.0f, is_one_object);
                for (const float depth : {6e-8f, 2.4e-7f, 2e-6f})
                    EXPECT_NEAR(hidden(depth, is_one_object), none, 1e-3) << scale << " " << eye.y << " " << depth;
                EXPECT_GT(hidden(2e-3f, is_one_object), none + 5.0) << scale << " " << eye.y;
            }
        }
}

TEST(visible_lines, an_edge_beside_a_needle_is_visible_from_both_of_its_sides)
{
    // A boolean operation put a corner 1e-9 above the lower edge of the front: exactly, the needle between them is
    // hidden from below by the lower side, whose plane it has.
    hw::MeshData mesh = box({-1, 0, -1}, {1, 1, 1});
    std::vector<std::uint32_t> indices;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto z = [&](std::size_t k) { return mesh.positions[mesh.indices[i + k]].z; };
        if (z(0) + z(1) + z(2) < 3.0f) indices.insert(indices.end(), &mesh.indices[i], &mesh.indices[i] + 3);
    }
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {{-1, 0, 1}, {1, 0, 1}, {1, 1, 1}, {-1, 1, 1}, {0.3f, 1e-9f, 1}});
    for (const std::uint32_t i : {0u, 1u, 4u, 0u, 4u, 3u, 4u, 2u, 3u, 4u, 1u, 2u}) indices.push_back(first + i);
    mesh.indices = indices;
    const hw::Surface plain = hw::build_surface(box({-1, 0, -1}, {1, 1, 1})), cut = hw::build_surface(mesh);
    for (const glm::dvec3& eye : {glm::dvec3(0.5, -3, 0.2), glm::dvec3(0.5, -3, 2), glm::dvec3(0.5, 3, 4)}) {
        const hw::LineCamera camera{.eye_world = eye, .target_world = {0, 0.5, 0}, .size_px = {800, 600}};
        const std::vector<hw::LineObject> expected{{&plain}}, objects{{&cut}};
        EXPECT_NEAR(total(hw::find_visible_lines(objects, camera), true, 0),
                    total(hw::find_visible_lines(expected, camera), true, 0), 1.0)
            << eye.y;
    }
}

TEST(visible_lines, faces_that_are_culled_hide_nothing_and_carry_no_lines)
{
    const hw::Surface block = hw::build_surface(turned_over(box({-1, -1, -1}, {1, 1, 1})));
    const hw::Surface square = upright_square();
    const glm::dmat4 small = glm::scale(glm::dmat4(1.0), glm::dvec3(0.3));
    std::vector<hw::LineObject> objects{{&block, glm::dmat4(1.0)}, {&square, small}};
    EXPECT_EQ(total(hw::find_visible_lines(objects, kFront), true, 1), 0.0);
    objects[0].is_culled = true;  // a room seen from outside through its wall
    EXPECT_GT(total(hw::find_visible_lines(objects, kFront), true, 1), 100.0);
}

TEST(visible_lines, an_edge_of_three_faces_is_left_out_only_where_all_of_them_are_culled)
{
    hw::MeshData mesh;
    mesh.positions = {{0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}, {0.5f, 0, -1}};
    mesh.indices = {0, 2, 1, 0, 1, 3, 0, 1, 4};
    const auto length = [](const hw::MeshData& faces) {
        const hw::Surface surface = hw::build_surface(faces);
        const std::vector<hw::LineObject> objects{{.surface = &surface, .is_culled = true}};
        return total(hw::find_visible_lines(objects, kFront), true, 0);
    };
    EXPECT_EQ(length(mesh), 0.0);
    for (std::size_t face = 0; face < 3; ++face) {
        hw::MeshData one_here = mesh;
        std::swap(one_here.indices[3 * face + 1], one_here.indices[3 * face + 2]);
        hw::MeshData alone = mesh;
        alone.indices.assign(&one_here.indices[3 * face], &one_here.indices[3 * face] + 3);
        EXPECT_NEAR(length(one_here), length(alone), 1.0) << face;
    }
}

TEST(visible_lines, a_meeting_with_a_wall_that_looks_away_is_no_line)
{
    const hw::Surface wall = upright_square();
    const auto meeting_px = [&](double turn_rad, bool is_culled) {
        const glm::dmat4 across = glm::rotate(at(0.2, 0, 0), turn_rad, glm::dvec3(0, 1, 0));
        const std::vector<hw::LineObject> objects{
            {.surface = &wall, .is_culled = true},
            {.surface = &wall, .world_from_object = glm::scale(across, glm::dvec3(0.5)), .is_culled = is_culled}};
        const auto cuts = hw::find_intersections(objects);
        double length_px = 0.0;
        for (const hw::VisibleLine& line : hw::find_visible_lines(objects, kFront, {.intersections = cuts}))
            if (line.line_class == Class::intersection) length_px += length_of(line);
        return length_px;
    };
    EXPECT_GT(meeting_px(-1.2, true), 20.0) << "it looks at the eye";
    EXPECT_EQ(meeting_px(-1.2 + M_PI, true), 0.0);
    EXPECT_GT(meeting_px(-1.2 + M_PI, false), 20.0);
}

TEST(visible_lines, a_wall_that_runs_straight_on_has_no_line_where_another_is_culled)
{
    hw::MeshData mesh;  // a wall that looks at kFront, and one that stands on it
    mesh.positions = {{0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}, {0.5f, 0, 1}};
    mesh.indices = {0, 1, 2, 0, 3, 1, 0, 4, 1};
    const auto length_in_the_middle = [&] {
        const hw::Surface surface = hw::build_surface(mesh);
        EXPECT_EQ(surface.report.complex_edges, 1u);
        const std::vector<hw::LineObject> objects{{.surface = &surface, .is_culled = true}};
        const std::vector<hw::VisibleLine> lines = hw::find_visible_lines(objects, kFront);
        const double middle_px = 0.5 * kFront.size_px.x;
        double length_px = 0.0;
        for (const hw::VisibleLine& line : lines)
            for (std::size_t i = 0; i + 1 < line.points_px.size(); ++i) {
                const glm::dvec2 &p = line.points_px[i], &q = line.points_px[i + 1];
                if (std::abs(p.x - middle_px) < 1.0 && std::abs(q.x - middle_px) < 1.0)
                    length_px += glm::distance(p, q);
            }
        return length_px;
    };
    EXPECT_GT(length_in_the_middle(), 50.0);
    std::swap(mesh.indices[7], mesh.indices[8]);
    EXPECT_EQ(length_in_the_middle(), 0.0);
}

namespace {

/// A sheet that looks at kFront, of twelve triangles left of x = -1, and a flap right of it that meets it back to
/// front, as levels have them.
hw::MeshData sheet_with_a_flap_back_to_front()
{
    hw::MeshData mesh;
    for (int i = 0; i <= 6; ++i)
        for (const float y : {-1.0f, 1.0f}) mesh.positions.emplace_back(-3.0f + static_cast<float>(i) / 3.0f, y, 0.0f);
    for (std::uint32_t i = 0; i < 12; i += 2)
        for (const std::uint32_t corner : {0u, 2u, 1u, 1u, 2u, 3u}) mesh.indices.push_back(i + corner);
    mesh.positions.insert(mesh.positions.end(), {{1, -1, 0}, {1, 1, 0}});
    const std::vector<std::uint32_t> flap{12, 13, 14, 13, 15, 14};
    mesh.indices.insert(mesh.indices.end(), flap.begin(), flap.end());
    return flat_shaded(mesh);
}

}  // namespace

TEST(visible_lines, a_wall_that_meets_its_neighbour_back_to_front_is_culled_as_the_model_winds_it)
{
    const hw::Surface sheet = hw::build_surface(sheet_with_a_flap_back_to_front());
    EXPECT_EQ(sheet.report.flipped_faces, 0u);
    const hw::Surface square = upright_square();
    const std::vector<hw::LineObject> objects{{.surface = &sheet, .is_culled = true},
                                              {&square, glm::scale(at(0, 0, -1), glm::dvec3(0.3))}};
    const std::vector<hw::VisibleLine> lines = hw::find_visible_lines(objects, kFront);
    EXPECT_GT(total(lines, true, 1), 100.0);
    for (const hw::VisibleLine& line : lines) EXPECT_EQ(line.line_class, Class::border);
}

TEST(visible_lines, what_is_seen_through_hides_nothing)
{
    const hw::Surface square = upright_square();
    std::vector<hw::LineObject> objects{{&square}, {&square, at(0.0, 0.0, -2.0)}};
    objects[0].hides = false;
    EXPECT_GT(total(hw::find_visible_lines(objects, kFront), true, 1), 100.0);
}

TEST(visible_lines, the_outline_of_a_sphere_is_one_closed_line)
{
    const hw::Surface ball = hw::build_surface(sphere(64, 32));
    const std::vector<hw::LineObject> objects{{&ball, glm::rotate(glm::dmat4(1.0), 0.3, glm::dvec3(0.3, 0.5, 0.1))}};
    const auto lines = hw::find_visible_lines(objects, kFront);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].line_class, Class::silhouette);
    EXPECT_TRUE(lines[0].is_closed);
    const double radius = 300.0 / std::tan(0.5 * kFront.fov_rad) / std::sqrt(99.0);
    EXPECT_NEAR(length_of(lines[0]), 2.0 * 3.141592653589793 * radius, 0.01 * length_of(lines[0]));
}

TEST(visible_lines, of_a_box_nine_edges_are_visible_and_six_of_them_are_its_outline)
{
    const hw::Surface block = hw::build_surface(box({-1, -1, -1}, {1, 1, 1}));
    const std::vector<hw::LineObject> objects{{&block}};
    const hw::LineCamera corner{.eye_world = {5, 6, 7}, .target_world = {0, 0, 0}, .size_px = {800, 600}};
    int outlines = 0;
    std::size_t inner = 0, hidden = 0;
    for (const auto& line : hw::find_visible_lines(objects, corner, {.with_hidden = true})) {
        const std::size_t segments = line.points_px.size() - (line.is_closed ? 0 : 1);
        if (line.line_class == Class::silhouette) {
            ++outlines;
            EXPECT_TRUE(line.is_visible && line.is_closed);
            EXPECT_EQ(segments, 6u);
            continue;
        }
        EXPECT_EQ(line.line_class, Class::ridge);
        (line.is_visible ? inner : hidden) += segments;
    }
    EXPECT_EQ(outlines, 1);
    EXPECT_EQ(inner, 3u);
    EXPECT_EQ(hidden, 3u);
}

TEST(visible_lines, do_not_depend_on_the_scale_of_the_world)
{
    const hw::Surface ring = hw::build_surface(torus(32, 16));
    std::vector<double> lengths;
    for (const double scale : {1e-5, 1.0, 1e5}) {
        const std::vector<hw::LineObject> objects{{&ring, glm::scale(glm::dmat4(1.0), glm::dvec3(scale))}};
        const hw::LineCamera camera{.eye_world = glm::dvec3(2, 1.5, 2.5) * scale,
                                    .target_world = {0, 0, 0},
                                    .size_px = {800, 600},
                                    .near_m = 0.001 * scale};
        lengths.push_back(total(hw::find_visible_lines(objects, camera), true, 0));
    }
    EXPECT_NEAR(lengths[0], lengths[1], 1e-6 * lengths[1]);
    EXPECT_NEAR(lengths[2], lengths[1], 1e-6 * lengths[1]);
}

TEST(visible_lines, cross_the_near_plane_without_a_jump)
{
    const hw::Surface floor = hw::build_surface(sheet(4, [](float, float) { return 0.0f; }));
    const std::vector<hw::LineObject> objects{{&floor, glm::scale(at(-50, -1.7, -50), glm::dvec3(100))}};
    const hw::LineCamera inside{.eye_world = {0, 0, 0}, .target_world = {0, 0, -1}, .size_px = {800, 600}};
    for (const auto& line : hw::find_visible_lines(objects, inside)) {
        for (const glm::dvec2& p : line.points_px) {
            EXPECT_TRUE(p.x >= -1e-6 && p.x <= 800.000001 && p.y >= -1e-6 && p.y <= 600.000001);
            EXPECT_GT(p.y, 300.0);  // below the horizon
        }
    }
}

TEST(visible_lines, what_the_eye_s_plane_cuts_open_hides_up_to_the_cut)
{
    const hw::Surface box = hw::build_surface(hw::test::box({-1, -1, -1}, {1, 1, 1})),
                      ball = hw::build_surface(sphere(128, 64)),
                      bar = hw::build_surface(hw::test::box({-3, 0.2f, -5.1f}, {3, 0.4f, -4.9f}));
    const auto bar_px = [&](const hw::Surface& around, const glm::dmat4& turn, double eye_z) {
        const std::vector<hw::LineObject> objects{{&around, turn}, {&bar}};
        const hw::LineCamera section{.eye_world = {0, 0, eye_z},
                                     .target_world = {0, 0, eye_z - 1.0},
                                     .orthographic_height_m = 8.0,
                                     .size_px = {800, 800},
                                     .near_m = 0.0,
                                     .far_m = 20.0};
        return total(hw::find_visible_lines(objects, section), true, 1);
    };
    const double whole = bar_px(box, at(100, 0, 0), 0.0);
    // Faces seen edge-on, and the same box turned by a hair either way.
    for (const double turn : {0.0, 1e-9, -1e-9, 1e-4, -1e-4})
        for (const double eye_z : {0.0, 0.9, -0.3, 1.001})
            EXPECT_NEAR(bar_px(box, glm::rotate(glm::dmat4(1.0), turn, {0, 1, 0}), eye_z), whole - 2 * 200.0, 0.2)
                << turn << " " << eye_z;
    // A ball that is cut beyond its middle hides no more than is left of it.
    for (const double eye_z : {0.5, 0.0, -0.5}) {
        const double radius = eye_z < 0.0 ? std::sqrt(1.0 - eye_z * eye_z) : 1.0;
        double hidden = 0.0;
        for (const double y : {0.2, 0.4}) hidden += 200.0 * std::sqrt(radius * radius - y * y);
        EXPECT_NEAR(bar_px(ball, glm::dmat4(1.0), eye_z), whole - hidden, 2.0) << eye_z;
    }
}

TEST(visible_lines, have_the_length_that_rays_through_many_samples_find)
{
    std::mt19937 random(9);
    std::uniform_real_distribution<float> place(-2.0f, 2.0f);
    hw::MeshData all;
    for (int i = 0; i < 25; ++i) {
        const glm::vec3 low(place(random), place(random), place(random));
        all = joined({all, box(low, low + glm::vec3(0.9f, 0.7f, 0.8f))});
    }
    const hw::Surface surface = hw::build_surface(all);
    const glm::dvec3 eye = kFront.eye_world;
    const auto is_seen = [&](const glm::dvec3& point) {
        return std::none_of(surface.faces.begin(), surface.faces.end(), [&](const auto& face) {
            const glm::dvec3 u = surface.positions[face[0]], v = surface.positions[face[1]],
                             w = surface.positions[face[2]];
            const glm::dvec3 normal = glm::cross(v - u, w - u), ray = point - eye;
            const double t = glm::dot(normal, u - eye) / glm::dot(normal, ray);
            if (!(t > 0.0 && t < 1.0 - 1e-6)) return false;
            const glm::dvec3 hit = eye + t * ray;
            return glm::dot(normal, glm::cross(v - u, hit - u)) >= 0.0 &&
                   glm::dot(normal, glm::cross(w - v, hit - v)) >= 0.0 &&
                   glm::dot(normal, glm::cross(u - w, hit - w)) >= 0.0;
        });
    };
    double expected = 0.0, whole = 0.0;
    const hw::EdgeRange ridges = hw::classes_at(surface, 0.7f).ridges[1];
    for (std::uint32_t edge = ridges.begin; edge < ridges.end; ++edge) {
        const glm::dvec3 a = surface.positions[hw::edge_vertices(surface, edge)[0]];
        const glm::dvec3 b = surface.positions[hw::edge_vertices(surface, edge)[1]];
        constexpr int kSamples = 200;
        for (int k = 0; k < kSamples; ++k) {
            const glm::dvec3 from = glm::mix(a, b, k / 200.0), to = glm::mix(a, b, (k + 1) / 200.0);
            const double length = glm::distance(pixel(from), pixel(to));
            whole += length;
            if (is_seen(0.5 * (from + to))) expected += length;
        }
    }
    const std::vector<hw::LineObject> objects{{&surface}};
    const auto lines = hw::find_visible_lines(objects, kFront, {.with_hidden = true});
    EXPECT_NEAR(total(lines, true, 0), expected, 0.003 * whole);
    EXPECT_NEAR(total(lines, true, 0) + total(lines, false, 0), whole, 1e-6 * whole);
    EXPECT_LT(expected, 0.7 * whole);
}

TEST(visible_lines, are_the_same_bytes_every_time)
{
    const hw::Surface ring = hw::build_surface(torus(48, 24));
    const std::vector<hw::LineObject> objects{{&ring}, {&ring, at(0.5, 0.2, -1)}};
    const auto first = hw::find_visible_lines(objects, kFront, {.with_hidden = true});
    for (int i = 0; i < 3; ++i) {
        const auto again = hw::find_visible_lines(objects, kFront, {.with_hidden = true});
        ASSERT_EQ(again.size(), first.size());
        for (std::size_t k = 0; k < first.size(); ++k) EXPECT_EQ(again[k].points_px, first[k].points_px);
    }
}

TEST(visible_lines, are_the_same_bytes_for_any_number_of_threads)
{
    const hw::Surface ring = hw::build_surface(torus(96, 48));
    std::vector<hw::LineObject> objects;
    for (int i = 0; i < 12; ++i) objects.push_back({&ring, at(0.3 * i - 1.5, 0.2 * (i % 3), -0.4 * i)});
    const auto cuts = hw::find_intersections(objects);
    const auto drawn_with = [&](int threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                        static_cast<std::size_t>(threads));
        return hw::find_visible_lines(objects, kFront, {.with_hidden = true, .intersections = cuts});
    };
    const auto alone = drawn_with(1);
    EXPECT_GT(alone.size(), 50u);
    for (const int threads : {2, 3, 8}) {
        const auto together = drawn_with(threads);
        ASSERT_EQ(together.size(), alone.size());
        for (std::size_t k = 0; k < alone.size(); ++k) {
            EXPECT_EQ(together[k].object, alone[k].object);
            EXPECT_EQ(together[k].is_visible, alone[k].is_visible);
            EXPECT_EQ(together[k].points_px, alone[k].points_px);
            EXPECT_EQ(together[k].inverse_depths, alone[k].inverse_depths);
        }
    }
}

TEST(visible_lines, of_a_tiny_model_have_all_their_rims)
{
    // A stepped ring: rims, creases, silhouettes that hide each other, as small as Line Art loses them.
    const auto lengths = [](float scale) {
        const hw::MeshData large = joined({torus(48, 24), moved(box({-2, -0.1f, -2}, {2, 0, 2}), glm::mat4(1.0f))});
        const hw::Surface surface = hw::build_surface(moved(large, glm::scale(glm::mat4(1.0f), glm::vec3(scale))));
        const std::vector<hw::LineObject> objects{{&surface}};
        const hw::LineCamera camera{.eye_world = glm::dvec3(3, 2.5, 4) * static_cast<double>(scale),
                                    .target_world = {0, 0, 0},
                                    .size_px = {800, 600},
                                    .near_m = 1e-3 * scale};
        const auto lines = hw::find_visible_lines(objects, camera, {.with_hidden = true});
        return std::array{total(lines, true, 0), total(lines, false, 0)};
    };
    const auto whole = lengths(1.0f);
    EXPECT_GT(whole[1], 100.0);
    for (const float scale : {1e-3f, 1e-6f}) {
        const auto tiny = lengths(scale);
        EXPECT_NEAR(tiny[0], whole[0], 1e-3 * whole[0]) << scale;
        EXPECT_NEAR(tiny[1], whole[1], 1e-3 * whole[1]) << scale;
    }
}

TEST(line_chains, pieces_that_meet_become_one_line)
{
    const std::vector<hw::LinePiece> pieces{
        {{0, 0}, {1, 0}, 0, 1}, {{2, 0}, {1, 0}, 2, 1}, {{2, 0}, {2, 5}, 2, hw::kFreeEnd}};
    const auto chains = hw::join_pieces(pieces);
    ASSERT_EQ(chains.size(), 1u);
    EXPECT_FALSE(chains[0].is_closed);
    EXPECT_EQ(chains[0].points.size(), 4u);
}

TEST(line_chains, where_four_meet_the_straight_ones_go_on)
{
    const std::vector<hw::LinePiece> cross{
        {{-1, 0}, {0, 0}, 1, 0}, {{0, -1}, {0, 0}, 2, 0}, {{0, 0}, {1, 0}, 0, 3}, {{0, 0}, {0, 1}, 0, 4}};
    const auto chains = hw::join_pieces(cross);
    ASSERT_EQ(chains.size(), 2u);
    EXPECT_EQ(chains[0].points.front().y, chains[0].points.back().y);
    EXPECT_EQ(chains[1].points.front().x, chains[1].points.back().x);
}

TEST(line_chains, a_ring_is_closed_and_repeats_no_point)
{
    const std::vector<hw::LinePiece> ring{{{0, 0}, {1, 0}, 0, 1}, {{0, 1}, {0, 0}, 2, 0}, {{1, 0}, {0, 1}, 1, 2}};
    const auto chains = hw::join_pieces(ring);
    ASSERT_EQ(chains.size(), 1u);
    EXPECT_TRUE(chains[0].is_closed);
    EXPECT_EQ(chains[0].points.size(), 3u);
}
