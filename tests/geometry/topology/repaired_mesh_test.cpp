// What public bug reports of similar programs showed: meshes as people have them, each kind by its name.
#include "hatchway/geometry/topology/repaired_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <random>

#include "hatchway/geometry/lines/visible_lines.hpp"
#include "hatchway/geometry/surface/surface.hpp"
#include "hatchway/geometry/topology/mesh_faults.hpp"
#include "hatchway/geometry/topology/shell.hpp"
#include "tests/geometry/test_meshes.hpp"

namespace {

using namespace hw::test;

/// Pixels of lines of each class that a culled object shows from an eye.
std::map<hw::LineClass, double> drawn_px(const hw::Surface& surface, const glm::dvec3& eye, bool is_culled = true)
{
    const std::vector<hw::LineObject> objects{{.surface = &surface, .is_culled = is_culled}};
    std::map<hw::LineClass, double> sums;
    const hw::LineCamera camera{.eye_world = eye, .target_world = {0.01, 0.02, 0.03}, .size_px = {1400, 900}};
    for (const hw::VisibleLine& line : hw::find_visible_lines(objects, camera)) {
        double& sum = sums[line.line_class];
        const std::size_t count = line.points_px.size();
        for (std::size_t i = 1; i < count + line.is_closed; ++i)
            sum += glm::distance(line.points_px[i - 1], line.points_px[i % count]);
    }
    return sums;
}

double all_px(const std::map<hw::LineClass, double>& sums)
{
    double sum = 0.0;
    for (const auto& [line_class, length] : sums) sum += length;
    return sum;
}

/// Each triangle once more with the opposite winding, on the same vertices or on others.
hw::MeshData doubled(const hw::MeshData& mesh, bool with_own_vertices)
{
    if (with_own_vertices) return joined({mesh, turned_over(mesh)});
    hw::MeshData both = mesh;
    const hw::MeshData turned = turned_over(mesh);
    // Side by side, as modellers write them.
    both.indices.clear();
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        both.indices.insert(both.indices.end(), &mesh.indices[i], &mesh.indices[i] + 3);
        both.indices.insert(both.indices.end(), &turned.indices[i], &turned.indices[i] + 3);
    }
    return both;
}

/// A roof of two quads that meet in a fold of 11 degrees.
hw::MeshData folded_sheet()
{
    return mesh_of({{-1, 0, -1}, {0, 0.1f, -1}, {1, 0, -1}, {-1, 0, 1}, {0, 0.1f, 1}, {1, 0, 1}},
                   {0, 3, 4, 0, 4, 1, 1, 4, 5, 1, 5, 2});
}

hw::MeshData cup()
{
    hw::MeshData mesh = sphere(16, 12);
    std::vector<std::uint32_t> lower;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        float highest = -2.0f;
        for (std::size_t k = i; k < i + 3; ++k) highest = std::max(highest, mesh.positions[mesh.indices[k]].y);
        if (highest < 0.3f) lower.insert(lower.end(), &mesh.indices[i], &mesh.indices[i] + 3);
    }
    mesh.indices = lower;
    return mesh;
}

const std::vector<glm::dvec3> kEyes{{3, 2.5, 4}, {-3, 2, 3.5}, {0.3, -3, 2}, {-2, -2.5, -3}};

/// A box of which the front's sides are cut by `cuts` more vertices at every edge that other sides have whole.
hw::MeshData box_with_t_junctions(int cuts, float off)
{
    hw::MeshData mesh = box({-1, -1, -1}, {1, 1, 1});
    // The front again, as a fan of triangles around its middle, with vertices on its four edges.
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        bool is_front = true;
        for (std::size_t k = i; k < i + 3; ++k) is_front &= mesh.positions[mesh.indices[k]].z == 1.0f;
        if (!is_front) kept.insert(kept.end(), &mesh.indices[i], &mesh.indices[i] + 3);
    }
    mesh.indices = kept;
    const glm::vec3 corners[4] = {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
    std::vector<glm::vec3> round;
    for (int side = 0; side < 4; ++side)
        for (int i = 0; i <= cuts; ++i) {
            glm::vec3 p =
                glm::mix(corners[side], corners[(side + 1) % 4], static_cast<float>(i) / static_cast<float>(cuts + 1));
            if (i > 0) p.z += off;
            round.push_back(p);
        }
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto count = static_cast<std::uint32_t>(round.size());
    mesh.positions.insert(mesh.positions.end(), round.begin(), round.end());
    mesh.positions.push_back({0, 0, 1});
    for (std::uint32_t i = 0; i < count; ++i)
        mesh.indices.insert(mesh.indices.end(), {first + count, first + i, first + (i + 1) % count});
    return mesh;
}

hw::MeshData with_turned(hw::MeshData mesh, std::span<const std::uint32_t> triangles)
{
    for (const std::uint32_t triangle : triangles)
        std::swap(mesh.indices[3 * triangle + 1], mesh.indices[3 * triangle + 2]);
    return mesh;
}

double volume(const hw::MeshData& mesh)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        sum += glm::dot(
            glm::cross(glm::dvec3(mesh.positions[mesh.indices[i]]), glm::dvec3(mesh.positions[mesh.indices[i + 1]])),
            glm::dvec3(mesh.positions[mesh.indices[i + 2]]));
    return sum / 6.0;
}

/// The same quads along their other diagonals. Triangles stand by pairs.
hw::MeshData cut_otherwise(hw::MeshData mesh)
{
    for (std::size_t i = 0; i + 5 < mesh.indices.size(); i += 6) {
        std::uint32_t* const t = &mesh.indices[i];
        const auto is_of_second = [&](std::uint32_t corner) { return std::find(t + 3, t + 6, corner) != t + 6; };
        while (is_of_second(t[0])) std::rotate(t, t + 1, t + 3);
        const auto is_of_first = [&](std::uint32_t corner) { return std::find(t, t + 3, corner) != t + 3; };
        while (is_of_first(t[3])) std::rotate(t + 3, t + 4, t + 6);
        const std::uint32_t a = t[0], b = t[1], c = t[3], d = t[2];
        const std::uint32_t made[6] = {a, b, c, a, c, d};
        std::copy(made, made + 6, t);
    }
    return mesh;
}

/// Every position somewhere within `reach` along each axis.
hw::MeshData shaken(hw::MeshData mesh, float reach)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> offset(-reach, reach);
    for (glm::vec3& p : mesh.positions) p += glm::vec3(offset(random), offset(random), offset(random));
    return mesh;
}

float diagonal(const hw::MeshData& mesh)
{
    glm::vec3 low = mesh.positions[0], high = low;
    for (const glm::vec3& p : mesh.positions) low = glm::min(low, p), high = glm::max(high, p);
    return glm::distance(low, high);
}

hw::MeshData waves()
{
    return sheet(9, [](float x, float z) { return 0.05f * std::sin(6.0f * x) * std::cos(5.0f * z); });
}

void expect_lines_of_single(const hw::MeshData& both, const hw::MeshData& single, double tolerance_px)
{
    const hw::Surface surface = hw::build_surface(both), expected = hw::build_surface(single, {.is_solid = false});
    EXPECT_EQ(surface.report.doubled_faces, single.triangle_count());
    EXPECT_EQ(surface.report.complex_edges, expected.report.complex_edges);
    EXPECT_EQ(surface.report.border_edges, expected.report.border_edges);
    for (const glm::dvec3& eye : kEyes) {
        const auto lines = drawn_px(surface, eye), lines_of_single = drawn_px(expected, eye, false);
        ASSERT_EQ(lines.size(), lines_of_single.size());
        for (const auto& [line_class, length] : lines_of_single)
            EXPECT_NEAR(lines.at(line_class), length, tolerance_px);
    }
}

/// Two cones on one rim, and a fin at one edge of it.
hw::MeshData lens_with_fin(float height)
{
    constexpr std::uint32_t kCount = 12;
    hw::MeshData mesh;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const float angle = 6.2831853f * static_cast<float>(i) / kCount;
        mesh.positions.push_back({std::cos(angle), 0, std::sin(angle)});
        mesh.indices.insert(mesh.indices.end(), {kCount, (i + 1) % kCount, i, kCount + 1, i, (i + 1) % kCount});
    }
    mesh.positions.insert(mesh.positions.end(), {{0, height, 0}, {0, -height, 0}, {2, 0, 0.5f}});
    mesh.indices.insert(mesh.indices.end(), {0, 1, kCount + 2});
    return mesh;
}

}  // namespace

TEST(doubled_faces, a_sheet_that_is_modelled_from_both_sides_has_no_line_at_its_folds)
{
    for (const bool with_own_vertices : {false, true}) {
        const hw::Surface surface = hw::build_surface(doubled(folded_sheet(), with_own_vertices));
        EXPECT_EQ(surface.report.doubled_faces, 4u);
        EXPECT_EQ(surface.report.border_edges, 6u);
        EXPECT_EQ(surface.report.complex_edges, 0u);
        for (const glm::dvec3& eye : kEyes) {
            const auto lines = drawn_px(surface, eye);
            EXPECT_EQ(lines.size(), 1u);
            EXPECT_NEAR(lines.at(hw::LineClass::border),
                        drawn_px(hw::build_surface(folded_sheet()), eye, false).at(hw::LineClass::border), 1e-6);
        }
    }
}

TEST(doubled_faces, a_closed_ball_and_a_cup_show_the_lines_of_the_single_two_sided_one)
{
    for (const hw::MeshData& mesh : {sphere(16, 12), cup(), torus(20, 10), box({-1, -1, -1}, {1, 1, 1})})
        for (const bool with_own_vertices : {false, true}) {
            const hw::Surface both = hw::build_surface(doubled(mesh, with_own_vertices));
            const hw::Surface single = hw::build_surface(mesh, {.is_solid = false});
            EXPECT_EQ(both.report.doubled_faces, mesh.triangle_count() - single.report.removed_faces);
            EXPECT_EQ(both.report.flipped_faces, 0u);
            for (const glm::dvec3& eye : kEyes) {
                const auto of_both = drawn_px(both, eye), of_single = drawn_px(single, eye, false);
                ASSERT_EQ(of_both.size(), of_single.size());
                for (const auto& [line_class, length] : of_single) EXPECT_NEAR(of_both.at(line_class), length, 1e-6);
            }
        }
}

TEST(doubled_faces, the_order_and_the_winding_of_the_copies_change_nothing)
{
    std::mt19937 random(12);
    hw::MeshData mesh = doubled(sphere(16, 12), true);
    const double expected = all_px(drawn_px(hw::build_surface(mesh), kEyes[0]));
    for (int trial = 0; trial < 5; ++trial) {
        std::vector<std::array<std::uint32_t, 3>> triangles;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
            triangles.push_back({mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
        std::shuffle(triangles.begin(), triangles.end(), random);
        mesh.indices.clear();
        for (const auto& t : triangles) mesh.indices.insert(mesh.indices.end(), t.begin(), t.end());
        EXPECT_NEAR(all_px(drawn_px(hw::build_surface(mesh), kEyes[0])), expected, 1e-6);
    }
}

TEST(doubled_faces, a_face_that_is_there_twice_the_same_way_is_there_once)
{
    const hw::MeshData one = box({-1, -1, -1}, {1, 1, 1});
    const hw::Surface surface = hw::build_surface(joined({one, one}));
    EXPECT_EQ(surface.report.doubled_faces, 12u);
    EXPECT_TRUE(surface.two_sided_faces.empty() || !surface.is_two_sided(0));
    EXPECT_EQ(surface.report.reflex_rule_components, 1u);
}

TEST(doubled_faces, sides_that_are_cut_into_triangles_in_another_way_are_one_sheet)
{
    for (const hw::MeshData& mesh : {folded_sheet(), torus(20, 10), waves()})
        for (const float scale : {1.0f, 1e-3f, 1e4f}) {
            const hw::MeshData single = moved(mesh, glm::scale(glm::mat4(1.0f), glm::vec3(scale)));
            const hw::MeshData other = turned_over(cut_otherwise(single));
            if (scale == 1.0f) expect_lines_of_single(joined({single, other}), single, 1e-6);
            EXPECT_EQ(hw::build_surface(joined({single, other})).report.doubled_faces, mesh.triangle_count());
            const hw::Surface twice = hw::build_surface(joined({single, cut_otherwise(single)}));
            EXPECT_EQ(twice.report.doubled_faces, mesh.triangle_count());
            EXPECT_FALSE(twice.is_two_sided(0));
        }
}

TEST(doubled_faces, a_flat_polygon_whose_other_side_is_another_fan_is_one_sheet)
{
    // Two polygons of nine corners on one edge: a fan around one corner, or one around the middle.
    const auto polygons = [](bool has_middle) {
        hw::MeshData mesh;
        for (const float side : {-1.0f, 1.0f}) {
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            for (int i = 0; i < 9; ++i) {
                const float angle = 3.1415927f * static_cast<float>(i) / 8.0f;
                const float out = i < 8 ? std::sin(angle) : 0.0f;
                mesh.positions.push_back({side * out, 0.2f * out, std::cos(angle)});
            }
            if (has_middle) mesh.positions.push_back({side * 0.3f, 0.06f, 0.1f});
            for (std::uint32_t i = 0; i < (has_middle ? 9u : 7u); ++i) {
                const std::uint32_t a = has_middle ? 9 : 0, b = has_middle ? i : i + 1,
                                    c = has_middle ? (i + 1) % 9 : i + 2;
                mesh.indices.insert(mesh.indices.end(), {first + a, first + b, first + c});
            }
        }
        return mesh;
    };
    for (const bool is_fan_first : {true, false}) {
        const hw::MeshData both = joined({polygons(!is_fan_first), turned_over(polygons(is_fan_first))});
        const hw::Surface surface = hw::build_surface(both);
        EXPECT_EQ(surface.report.doubled_faces, is_fan_first ? 18u : 14u);
        EXPECT_EQ(surface.report.complex_edges, 0u);
    }
}

TEST(doubled_faces, sides_that_roundings_moved_apart_are_one_sheet)
{
    for (const hw::MeshData& mesh : {folded_sheet(), cup(), waves()})
        for (const float share : {1e-7f, 1e-6f, 4e-6f})
            for (const float scale : {1.0f, 1e-3f, 1e4f}) {
                const hw::MeshData single = moved(mesh, glm::scale(glm::mat4(1.0f), glm::vec3(scale)));
                const hw::MeshData back = shaken(turned_over(single), share * diagonal(single));
                const hw::Surface surface = hw::build_surface(joined({single, back}));
                const hw::Surface expected = hw::build_surface(single);
                EXPECT_EQ(surface.report.doubled_faces, mesh.triangle_count() - expected.report.removed_faces);
                EXPECT_EQ(surface.report.complex_edges, 0u);
                EXPECT_EQ(surface.report.border_edges, expected.report.border_edges) << share << " " << scale;
            }
    for (const hw::MeshData& mesh : {folded_sheet(), waves()}) {
        expect_lines_of_single(joined({mesh, shaken(turned_over(mesh), 2e-6f)}), mesh, 0.01);
        expect_lines_of_single(joined({mesh, shaken(turned_over(cut_otherwise(mesh)), 2e-6f)}), mesh, 0.01);
    }
}

TEST(doubled_faces, two_sides_of_a_body_stay_however_thin_it_is)
{
    for (const float height : {0.3f, 0.01f, 1e-3f})
        EXPECT_EQ(hw::build_surface(lens_with_fin(height)).report.doubled_faces, 0u) << height;
    // A plate that is thinner than what borders are joined within, its sides cut into small faces.
    hw::MeshData plate = waves();
    const auto count = static_cast<std::uint32_t>(plate.positions.size());
    const hw::MeshData top = moved(plate, glm::translate(glm::mat4(1.0f), {0, 3e-6f, 0}));
    plate = joined({turned_over(plate), top});
    for (std::uint32_t i = 0; i < 9; ++i)
        plate.indices.insert(plate.indices.end(), {i, i + 1, count + i, i + 1, count + i + 1, count + i});
    EXPECT_EQ(hw::build_surface(plate).report.doubled_faces, 0u);
    const hw::MeshData kite =
        mesh_of({{0, 0.05f, 0}, {1, -0.05f, 0}, {1, 0.05f, 1}, {0, -0.05f, 1}}, {0, 2, 1, 0, 3, 2, 0, 1, 3, 1, 2, 3});
    EXPECT_EQ(hw::build_surface(kite).report.doubled_faces, 0u);
}

TEST(t_junctions, every_edge_of_a_box_is_one_ridge_however_its_front_is_cut)
{
    for (const int cuts : {1, 2, 5}) {
        for (const float off : {0.0f, 1.2e-7f, -1.2e-7f, 1e-6f}) {
            const hw::Surface surface = hw::build_surface(box_with_t_junctions(cuts, off));
            EXPECT_EQ(surface.report.border_edges, 0u) << cuts << " cuts, " << off;
            EXPECT_EQ(surface.report.t_junction_edges, 4u);
            EXPECT_EQ(surface.report.closed_components, 1u);
            EXPECT_EQ(surface.report.reflex_rule_components, 1u);
            for (const glm::dvec3& eye : kEyes) {
                const auto lines = drawn_px(surface, eye);
                const auto plain = drawn_px(hw::build_surface(box({-1, -1, -1}, {1, 1, 1})), eye);
                ASSERT_EQ(lines.size(), plain.size()) << cuts << " cuts, " << off;
                for (const auto& [line_class, length] : plain) EXPECT_NEAR(lines.at(line_class), length, 0.01);
            }
        }
    }
}

TEST(t_junctions, borders_that_are_cut_at_different_places_on_both_sides_are_joined)
{
    // Two strips of a floor along z = 0: the one is cut at x = 1 and 2, the other at 1.5.
    const hw::MeshData mesh =
        mesh_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5f, 0, -1}, {1.5f, 0, 0}, {1.5f, 0, 1}},
                {4, 0, 1, 4, 1, 2, 4, 2, 3, 6, 5, 0, 6, 3, 5});
    const hw::Surface surface = hw::build_surface(mesh);
    EXPECT_EQ(surface.report.border_edges, 4u);
    EXPECT_EQ(surface.report.complex_edges, 0u);
    EXPECT_EQ(surface.report.t_junction_edges, 3u);
}

TEST(t_junctions, a_front_that_is_turned_over_or_there_from_both_sides_is_joined_all_the_same)
{
    const hw::MeshData whole = box({-1, -1, -1}, {1, 1, 1});
    for (const int cuts : {1, 2, 5}) {
        const hw::MeshData mesh = box_with_t_junctions(cuts, 0.0f);
        std::vector<std::uint32_t> front;
        for (std::uint32_t triangle = 10; triangle < mesh.triangle_count(); ++triangle) front.push_back(triangle);
        const hw::Surface turned = hw::build_surface(with_turned(mesh, front));
        EXPECT_EQ(turned.report.t_junction_edges, 4u) << cuts;
        EXPECT_EQ(turned.report.flipped_faces, front.size());
        EXPECT_EQ(turned.report.closed_components, 1u);
        const hw::Surface some_turned = hw::build_surface(with_turned(mesh, std::vector<std::uint32_t>{3, 11, 12}));
        EXPECT_EQ(some_turned.report.flipped_faces, 3u);
        const hw::Surface both = hw::build_surface(doubled(with_turned(mesh, std::vector<std::uint32_t>{3, 11}), true));
        const hw::Surface plain = hw::build_surface(whole), plain_both = hw::build_surface(doubled(whole, true));
        EXPECT_EQ(both.report.border_edges, 0u);
        for (const glm::dvec3& eye : kEyes) {
            EXPECT_NEAR(all_px(drawn_px(turned, eye)), all_px(drawn_px(plain, eye)), 0.01) << cuts;
            EXPECT_NEAR(all_px(drawn_px(some_turned, eye)), all_px(drawn_px(plain, eye)), 0.01) << cuts;
            EXPECT_NEAR(all_px(drawn_px(both, eye)), all_px(drawn_px(plain_both, eye)), 0.01) << cuts;
        }
    }
}

TEST(t_junctions, a_sheet_that_lies_on_another_is_not_joined_with_it)
{
    // A rug whose edge is a part of the floor's, and both look up.
    const hw::MeshData mesh =
        mesh_of({{0, 0, 0}, {3, 0, 0}, {3, 0, 3}, {0, 0, 3}, {1, 0, 0}, {2, 0, 0}, {2, 0, 1}, {1, 0, 1}},
                {0, 2, 1, 0, 3, 2, 4, 6, 5, 4, 7, 6});
    const hw::Surface surface = hw::build_surface(mesh);
    EXPECT_EQ(surface.report.t_junction_edges, 0u);
    EXPECT_EQ(surface.report.flipped_faces, 0u);
}

TEST(t_junctions, what_is_left_of_a_border_stays_one)
{
    // The upper face is two long, the lower one only meets its left half.
    const hw::MeshData mesh = mesh_of({{0, 0, 0}, {2, 0, 0}, {1, 0, -1}, {1, 0, 0}, {0.5f, -1, 0}}, {0, 1, 2, 3, 0, 4});
    const hw::Surface surface = hw::build_surface(mesh);
    EXPECT_EQ(surface.report.t_junction_edges, 1u);
    EXPECT_EQ(surface.report.border_edges, 5u);
}

TEST(t_junctions, a_corner_that_only_touches_a_border_joins_nothing)
{
    const hw::MeshData mesh =
        mesh_of({{0, 0, 0}, {2, 0, 0}, {1, 0, -1}, {1, 0, 0}, {2, 0, 1}, {0, 0, 1}}, {0, 1, 2, 3, 5, 4});
    EXPECT_EQ(hw::build_surface(mesh).report.t_junction_edges, 0u);
}

namespace {

std::vector<std::uint32_t> wrongly_wound(const hw::MeshData& mesh)
{
    return hw::find_mesh_faults(mesh).wrongly_wound;
}

}  // namespace

TEST(winding, turned_triangles_of_closed_solids_are_found_in_every_component)
{
    const std::vector<std::uint32_t> few{3, 7}, many{0, 2, 4, 9, 11};
    const hw::MeshData two =
        joined({with_turned(box({-1, -1, -1}, {1, 1, 1}), few), with_turned(box({3, 0, 0}, {4, 1, 1}), many)});
    const std::vector<std::uint32_t> expected{3, 7, 12, 14, 16, 21, 23};
    EXPECT_EQ(wrongly_wound(two), expected);
    hw::MeshData repaired = two;
    hw::turn_over(repaired, expected);
    EXPECT_NEAR(volume(repaired), 9.0, 1e-6);
    EXPECT_TRUE(wrongly_wound(repaired).empty());
}

TEST(winding, of_two_equal_halves_the_solid_is_kept)
{
    const std::vector<std::uint32_t> half{0, 1, 2, 3, 4, 5};
    hw::MeshData mesh = with_turned(box({-1, -1, -1}, {1, 1, 1}), half);
    hw::turn_over(mesh, wrongly_wound(mesh));
    EXPECT_NEAR(volume(mesh), 8.0, 1e-6);
}

TEST(winding, a_room_is_left_as_it_is)
{
    EXPECT_TRUE(wrongly_wound(turned_over(box({-1, -1, -1}, {1, 1, 1}))).empty());
}

TEST(winding, a_normal_that_looked_to_the_back_turns_with_its_triangle)
{
    const std::vector<std::uint32_t> one{4};
    const hw::MeshData flat = flat_shaded(with_turned(box({-1, -1, -1}, {1, 1, 1}), one));
    hw::MeshData mesh = flat;
    hw::turn_over(mesh, wrongly_wound(mesh));
    EXPECT_EQ(mesh.normals[mesh.indices[12]], -flat.normals[flat.indices[12]]);
    EXPECT_EQ(mesh.normals[mesh.indices[0]], flat.normals[flat.indices[0]]);
}

TEST(winding, in_an_open_mesh_a_triangle_stays_whose_own_normals_look_where_its_winding_does)
{
    const std::vector<std::uint32_t> one{3};
    hw::MeshData mesh = flat_shaded(with_turned(cup(), one));
    mesh.has_own_normals = true;
    EXPECT_TRUE(wrongly_wound(mesh).empty());
    mesh.has_own_normals = false;
    EXPECT_EQ(wrongly_wound(mesh), one);
    mesh.has_own_normals = true;
    for (std::size_t i = 9; i < 12; ++i) mesh.normals[mesh.indices[i]] *= -1.0f;
    EXPECT_EQ(wrongly_wound(mesh), one);
}

TEST(winding, of_sheets_from_both_sides_nothing_is_turned)
{
    EXPECT_TRUE(wrongly_wound(doubled(sphere(16, 12), true)).empty());
    EXPECT_TRUE(wrongly_wound(doubled(folded_sheet(), false)).empty());
}

TEST(winding, what_is_closed_and_wound_alike_is_a_shell)
{
    const std::vector<std::uint32_t> few{3, 7};
    EXPECT_TRUE(hw::is_shell(box({-1, -1, -1}, {1, 1, 1})));
    EXPECT_TRUE(hw::is_shell(flat_shaded(torus(20, 10))));
    EXPECT_TRUE(hw::is_shell(with_turned(box({-1, -1, -1}, {1, 1, 1}), few)));
    EXPECT_TRUE(hw::is_shell(box_with_t_junctions(2, 0.0f)));
    EXPECT_FALSE(hw::is_shell(cup()));
    EXPECT_FALSE(hw::is_shell(joined({box({-1, -1, -1}, {1, 1, 1}), cup()})));
    EXPECT_FALSE(hw::is_shell(doubled(sphere(16, 12), true)));
    EXPECT_FALSE(hw::is_shell(klein_bottle(12, 12)));
}

TEST(winding, sheets_wind_the_same_way_however_they_wound)
{
    const hw::MeshData floor = sheet(2, [](float x, float) { return 0.1f * x; });
    hw::MeshData up = floor, down = turned_over(floor);
    for (hw::MeshData* mesh : {&up, &down}) hw::turn_over(*mesh, hw::find_mesh_faults(*mesh).of_turned_sheets);
    for (std::size_t i = 0; i < up.indices.size(); i += 3) {
        const auto corner = [](const hw::MeshData& mesh, std::size_t k) { return mesh.positions[mesh.indices[k]]; };
        const auto normal = [&](const hw::MeshData& mesh) {
            return glm::cross(corner(mesh, i + 1) - corner(mesh, i), corner(mesh, i + 2) - corner(mesh, i));
        };
        EXPECT_GT(normal(up).y, 0.0f);
        EXPECT_GT(normal(down).y, 0.0f);
    }
    EXPECT_TRUE(hw::find_mesh_faults(turned_over(sphere(16, 12))).of_turned_sheets.empty());
}

namespace {

/// A globe by float trigonometry: at both poles the ring of the last corners does not close, being `pole` wide.
hw::MeshData globe(float pole, const glm::vec3& radii, const glm::vec3& centre = glm::vec3(0.0f))
{
    constexpr std::uint32_t kColumns = 20, kRings = 12;
    hw::MeshData mesh;
    for (std::uint32_t ring = 0; ring <= kRings; ++ring)
        for (std::uint32_t column = 0; column < kColumns; ++column) {
            const bool is_pole = ring == 0 || ring == kRings;
            const double down = M_PI * ring / kRings, around = 2.0 * M_PI * column / kColumns;
            const double wide = is_pole ? 0.5 * static_cast<double>(pole) : std::sin(down);
            const glm::dvec3 unit(wide * std::cos(around), std::cos(down), wide * std::sin(around));
            mesh.positions.emplace_back(glm::dvec3(centre) + unit * glm::dvec3(radii));
        }
    for (std::uint32_t ring = 0; ring < kRings; ++ring)
        for (std::uint32_t column = 0; column < kColumns; ++column) {
            const std::uint32_t a = ring * kColumns + column, b = ring * kColumns + (column + 1) % kColumns;
            const std::uint32_t c = a + kColumns, d = b + kColumns;
            mesh.indices.insert(mesh.indices.end(), {a, b, c, b, d, c});
        }
    return mesh;
}

/// Makes a hole so wide of a vertex: each triangle gets a corner of its own there, and slivers lie between them.
hw::MeshData punctured(hw::MeshData mesh, std::uint32_t vertex, float wide)
{
    struct Wedge {
        std::uint32_t corner, before, after;
    };
    std::vector<Wedge> fan;
    glm::vec3 beside(0.0f);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            if (mesh.indices[i + k] != vertex) continue;
            const std::uint32_t before = mesh.indices[i + (k + 1) % 3], after = mesh.indices[i + (k + 2) % 3];
            const glm::vec3 middle = 0.5f * (mesh.positions[before] + mesh.positions[after]);
            const glm::vec3 away = glm::normalize(middle - mesh.positions[vertex]);
            fan.push_back({static_cast<std::uint32_t>(mesh.positions.size()), before, after});
            mesh.positions.push_back(mesh.positions[vertex] + 0.5f * wide * away);
            mesh.indices[i + k] = fan.back().corner;
        }
    for (const Wedge& wedge : fan)
        for (const Wedge& next : fan)
            if (next.before == wedge.after)
                mesh.indices.insert(mesh.indices.end(), {wedge.corner, wedge.after, next.corner});
    return mesh;
}

}  // namespace

TEST(pinholes, the_poles_of_a_globe_by_float_trigonometry_are_points)
{
    const std::vector<glm::vec3> shapes{{1, 1, 1}, {1, 0.5f, 2}, {0.2f, 40, 0.2f}, {30, 1, 0.5f}};
    for (const glm::vec3& radii : shapes)
        for (const float far : {0.0f, 0.3f, 50.0f, 1000.03f}) {
            const hw::MeshData mesh = globe(1.8e-7f, radii, glm::vec3(far, 0.1f * far, -far));
            const hw::Surface surface = hw::build_surface(mesh, {.world_from_object = glm::dmat3(2.0)});
            EXPECT_EQ(surface.report.border_edges, 0u) << radii.x << " " << far;
            EXPECT_EQ(surface.report.complex_edges, 0u) << radii.x << " " << far;
            EXPECT_EQ(surface.report.reflex_rule_components, 1u) << radii.x << " " << far;
        }
    const hw::Surface squashed =
        hw::build_surface(globe(1.8e-7f, {1, 1, 1}), {.world_from_object = {{1, 0, 0}, {0, 0.01, 0}, {0, 0, 50}}});
    EXPECT_EQ(squashed.report.border_edges, 0u) << "the scale is that of the node";
}

TEST(pinholes, a_globe_has_its_outline_and_no_star_at_its_poles)
{
    const hw::Surface surface = hw::build_surface(globe(1.8e-7f, {1, 0.7f, 1}));
    const hw::Surface whole = hw::build_surface(globe(0.0f, {1, 0.7f, 1}));
    for (const glm::dvec3& eye : {glm::dvec3(0.3, -3, 0.2), glm::dvec3(2, 2, 1), glm::dvec3(3, 0.1, 0)}) {
        const auto lines = drawn_px(surface, eye), expected = drawn_px(whole, eye);
        ASSERT_EQ(lines.size(), 1u);
        EXPECT_NEAR(lines.at(hw::LineClass::silhouette), expected.at(hw::LineClass::silhouette), 0.5);
    }
}

TEST(pinholes, several_of_one_shell_are_closed_and_holes_that_can_be_seen_stay)
{
    hw::MeshData mesh = sphere(16, 12);
    for (const std::uint32_t vertex : {20u, 55u, 90u, 131u}) mesh = punctured(mesh, vertex, 8e-7f);
    const hw::Surface surface = hw::build_surface(mesh);
    EXPECT_EQ(surface.report.pinholes, 4u);
    EXPECT_EQ(surface.report.border_edges, 0u);
    EXPECT_EQ(surface.faces.size(), hw::build_surface(sphere(16, 12)).faces.size());
    const hw::Surface holed = hw::build_surface(punctured(mesh, 75, 1e-3f));
    EXPECT_EQ(holed.report.pinholes, 4u);
    EXPECT_EQ(holed.report.border_edges, 6u);
}

TEST(pinholes, right_at_a_border_are_closed_and_the_border_stays)
{
    // A square whose lower side has a corner in its middle, and there begins a hole of three corners: small, or a
    // kilometre away as wide as the step from float to float.
    for (const auto& [x, w] : {std::pair{0.0f, 1e-6f}, {1000.0f, 0x1p-14f}}) {
        const hw::MeshData at_corner = mesh_of({{x - 1, 0, 0},
                                                {x + 1, 0, 0},
                                                {x + 1, 2, 0},
                                                {x - 1, 2, 0},
                                                {x, 0, 0},
                                                {x + w, 2 * w, 0},
                                                {x - w, 2 * w, 0}},
                                               {0, 4, 6, 0, 6, 3, 6, 5, 2, 6, 2, 3, 4, 1, 5, 5, 1, 2});
        const hw::Surface surface = hw::build_surface(at_corner);
        EXPECT_EQ(surface.report.pinholes, 1u) << x;
        EXPECT_EQ(surface.report.border_edges, 5u) << x;
    }
    // One ring below the rim of a cup.
    const std::uint32_t rim = hw::build_surface(cup()).report.border_edges;
    std::uint32_t below = 0;
    const hw::MeshData whole = cup();
    for (std::uint32_t i = 0; i < whole.positions.size(); ++i) {
        const float y = whole.positions[i].y;
        if (y < 0.1f && y > whole.positions[below].y - 1.0f && std::abs(y) < 0.1f) below = i;
    }
    const hw::Surface holed = hw::build_surface(punctured(whole, below, 6e-7f));
    EXPECT_EQ(holed.report.pinholes, 1u);
    EXPECT_EQ(holed.report.border_edges, rim);
}

TEST(pinholes, small_pieces_beside_large_ones_keep_their_shape_and_lose_their_own_pinholes)
{
    const auto tiny = [](const hw::MeshData& mesh) {
        return moved(mesh, glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(2.0f, 0.0f, 0.0f)), glm::vec3(1e-5f)));
    };
    const hw::MeshData sheet_of_two = mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0, 1, 2, 0, 2, 3});
    const hw::MeshData large = sphere(16, 12);
    const std::size_t of_large = hw::build_surface(large).faces.size();
    for (const hw::MeshData& mesh : {sheet_of_two, cup()}) {
        const hw::Surface alone = hw::build_surface(tiny(mesh));
        const hw::Surface both = hw::build_surface(joined({large, tiny(mesh)}));
        EXPECT_EQ(both.report.pinholes, 0u);
        EXPECT_EQ(both.faces.size(), of_large + alone.faces.size());
        EXPECT_EQ(both.report.border_edges, alone.report.border_edges);
    }
    const hw::MeshData small = globe(1e-6f, glm::vec3(0.01f), glm::vec3(0, 2, 0));
    EXPECT_EQ(hw::build_surface(joined({large, small})).report.border_edges, 0u);
}
