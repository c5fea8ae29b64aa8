// The hard cases of meshes and viewers, each by its name.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "hatchway/geometry/exact/predicates.hpp"
#include "tests/geometry/silhouettes/silhouette_checks.hpp"
#include "tests/geometry/test_meshes.hpp"

namespace {

using namespace hw::test;

constexpr auto kRational = hw::SilhouetteOracle::Arithmetic::rational_only;

/// With clusters, so that both ways to find silhouettes are tried.
hw::Surface surface_of(const hw::MeshData& mesh)
{
    return hw::build_surface(mesh, {.cluster_from_faces = 1});
}

/// Two faces on the edge from the origin to +z; the second's apex is `height` above the plane y = 0 of the first.
hw::MeshData flaps(float height)
{
    return mesh_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 0.5f}, {-1, height, 0.5f}}, {0, 1, 2, 1, 0, 3});
}

/// A fan of `count` faces around the edge from the origin to +z.
hw::MeshData fan(int count)
{
    hw::MeshData mesh = mesh_of({{0, 0, 0}, {0, 0, 1}}, {});
    for (int i = 0; i < count; ++i) {
        const auto angle = static_cast<float>(6.2831853 * i / count);
        mesh.positions.push_back({std::cos(angle), std::sin(angle), 0.5f});
        for (const std::uint32_t index : {0u, 1u, static_cast<std::uint32_t>(2 + i)}) mesh.indices.push_back(index);
    }
    return mesh;
}

/// A closed box whose front has a vertex in the middle of one edge, closed by a collinear cap, as exporters do.
hw::MeshData box_with_t_junction_cap()
{
    hw::MeshData mesh = box({0, 0, 0}, {2, 2, 2});
    mesh.positions.push_back({2, 0, 1});  // in the middle of the edge from 1 (2,0,0) to 5 (2,0,2)
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        std::uint32_t* t = &mesh.indices[i];
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t from = t[corner], to = t[(corner + 1) % 3], apex = t[(corner + 2) % 3];
            if (from != 5 || to != 1) continue;  // the side x = 2 gets the vertex, the side y = 0 does not
            t[0] = from, t[1] = 8, t[2] = apex;
            for (const std::uint32_t index : {8u, to, apex, from, to, 8u}) mesh.indices.push_back(index);
            return mesh;
        }
    }
    return mesh;
}

}  // namespace

TEST(hard_meshes, zero_area_triangle)
{
    const hw::Surface surface = surface_of(box_with_t_junction_cap());
    EXPECT_EQ(surface.report.collinear_faces, 1u);
    EXPECT_EQ(surface.report.closed_components, 1u);
    EXPECT_EQ(wrong_edges_in_all_views(surface, true), 0u);
}

TEST(hard_meshes, a_collinear_face_lets_no_crease_appear_on_its_longest_side)
{
    const hw::Surface surface = surface_of(box_with_t_junction_cap());
    // 12 edges of the box, one of them in two halves; the cap's longest side is flat.
    EXPECT_EQ(hw::classes_at(surface, 0.7f).crease_count(), 13u);
}

TEST(hard_meshes, a_collinear_face_alone_is_back_facing)
{
    const hw::Surface surface = surface_of(mesh_of({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {0, 1, 2}));
    hw::SilhouetteScratch scratch;
    hw::find_facing(surface, {glm::dvec3(1, 2, 3)}, hw::FacingPrecision::exact, scratch);
    EXPECT_FALSE(hw::is_front_facing(scratch, 0));
}

TEST(hard_meshes, sliver)
{
    const hw::MeshData mesh = moved(sphere(12, 8), glm::scale(glm::mat4(1.0f), glm::vec3(1.0f, 1e-8f, 1.0f)));
    EXPECT_EQ(wrong_edges_in_all_views(surface_of(mesh), true), 0u);
}

TEST(hard_meshes, duplicated_vertices)
{
    const hw::Surface surface = surface_of(flat_shaded(torus(20, 10)));
    EXPECT_EQ(surface.positions.size(), 200u);
    EXPECT_EQ(surface.report.closed_components, 1u);
    EXPECT_EQ(wrong_edges_in_all_views(surface, true), 0u);
}

TEST(hard_meshes, vertices_one_ulp_apart)
{
    hw::MeshData mesh = flat_shaded(sphere(12, 8));
    for (std::size_t i = 0; i < mesh.positions.size(); i += 2)
        mesh.positions[i].x = std::nextafter(mesh.positions[i].x, 9.0f);
    const hw::Surface surface = surface_of(mesh);
    EXPECT_EQ(surface.report.border_edges, 0u);
    EXPECT_GT(surface.report.stitched_edges, 0u);
    EXPECT_EQ(wrong_edges_in_all_views(surface, true), 0u);
}

TEST(hard_meshes, vertices_1e_4_apart_stay_apart)
{
    hw::MeshData mesh = sheet(4, [](float, float) { return 0.0f; });
    const hw::MeshData next = moved(mesh, glm::translate(glm::mat4(1.0f), glm::vec3(1.0001f, 0, 0)));
    EXPECT_EQ(surface_of(joined({mesh, next})).report.stitched_edges, 0u);
}

TEST(hard_meshes, t_junction)
{
    // Without a cap of its own the junction gets one: else it is two short borders against a long one.
    hw::MeshData mesh = box_with_t_junction_cap();
    mesh.indices.resize(mesh.indices.size() - 3);
    const hw::Surface surface = surface_of(mesh);
    EXPECT_EQ(surface.report.border_edges, 0u);
    EXPECT_EQ(surface.report.t_junction_edges, 1u);
    EXPECT_EQ(surface.report.closed_components, 1u);
    EXPECT_EQ(wrong_edges_in_all_views(surface, true), 0u);
}

TEST(hard_meshes, fan_of_three_to_eight_faces_on_one_edge)
{
    for (int count = 3; count <= 8; ++count) {
        const hw::Surface surface = surface_of(fan(count));
        EXPECT_EQ(surface.report.complex_edges, 1u);
        EXPECT_EQ(surface.report.border_edges, 2u * count);
        EXPECT_EQ(surface.faces.size(), static_cast<std::size_t>(count));
        EXPECT_EQ(wrong_edges_in_all_views(surface, true), 0u);
    }
}

TEST(hard_meshes, two_cubes_sharing_an_edge)
{
    const hw::Surface surface = surface_of(joined({box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1})}));
    EXPECT_EQ(surface.report.complex_edges, 1u);
    EXPECT_EQ(surface.report.components, 2u);
    EXPECT_EQ(surface.report.closed_components, 0u);
    EXPECT_EQ(wrong_edges_in_all_views(surface, true), 0u);
}

TEST(hard_meshes, moebius_strip)
{
    const hw::Surface surface = surface_of(moebius_strip(40));
    EXPECT_EQ(surface.report.inconsistent_edges, 1u);
    EXPECT_EQ(surface.report.reflex_rule_components, 0u);
    EXPECT_EQ(wrong_edges_in_all_views(surface, true), 0u);
}

TEST(hard_meshes, a_moebius_strip_shows_no_line_where_its_winding_turns)
{
    const hw::Surface surface = surface_of(moebius_strip(400));
    std::uint32_t turn = 0;
    for (std::uint32_t edge = 0; edge < surface.edges.size(); ++edge) {
        if (surface.edges[edge].face_b != hw::kNoFace && surface.edges[edge].face_b >= surface.faces.size())
            turn = edge;
    }
    ASSERT_LT(hw::fold_rad(surface, turn), 0.1f);
    hw::SilhouetteScratch scratch;
    int drawn = 0;
    for (const glm::dvec3& eye : eyes_around(surface)) {
        for (const std::uint32_t edge : hw::drawn_contours(surface, {eye}, {}, scratch)) drawn += edge == turn;
    }
    EXPECT_LE(drawn, 2);
}

TEST(hard_meshes, klein_bottle)
{
    const hw::Surface surface = surface_of(klein_bottle(24, 16));
    EXPECT_EQ(surface.report.border_edges, 0u);
    EXPECT_GT(surface.report.inconsistent_edges, 0u);
    EXPECT_EQ(surface.report.closed_components, 0u);
    EXPECT_EQ(wrong_edges_in_all_views(surface, true), 0u);
}

TEST(hard_meshes, one_flipped_face)
{
    hw::MeshData mesh = torus(20, 10);
    std::swap(mesh.indices[30], mesh.indices[31]);
    const hw::Surface surface = surface_of(mesh);
    EXPECT_EQ(surface.report.flipped_faces, 1u);
    EXPECT_EQ(surface.report.closed_components, 1u);
    EXPECT_EQ(wrong_edges_in_all_views(surface, true), 0u);
}

TEST(hard_meshes, single_triangle_from_both_sides)
{
    const hw::Surface surface = surface_of(mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}));
    EXPECT_EQ(surface.report.border_edges, 3u);
    hw::SilhouetteScratch scratch;
    hw::find_facing(surface, {glm::dvec3(0.2, 0.2, 1)}, hw::FacingPrecision::exact, scratch);
    EXPECT_TRUE(hw::is_front_facing(scratch, 0));
    hw::find_facing(surface, {glm::dvec3(0.2, 0.2, -1)}, hw::FacingPrecision::exact, scratch);
    EXPECT_FALSE(hw::is_front_facing(scratch, 0));
    EXPECT_TRUE(hw::all_silhouettes(surface, {glm::dvec3(0.2, 0.2, 1)}, {}, scratch).empty());
}

TEST(hard_meshes, a_sheet_and_its_back_are_one_sheet)
{
    const hw::MeshData front = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2});
    const hw::Surface surface = surface_of(joined({front, turned_over(front)}));
    EXPECT_EQ(surface.report.border_edges, 3u);
    EXPECT_EQ(surface.edges.size(), 3u);
    EXPECT_EQ(wrong_edges_in_all_views(surface, true), 0u);
}

TEST(hard_meshes, non_planar_quad_and_coplanar_diagonals)
{
    const hw::Surface flat = surface_of(sheet(4, [](float x, float z) { return 0.5f * x + 0.25f * z; }));
    EXPECT_EQ(hw::classes_at(flat, 0.7f).candidate_count(), 0u);
    const hw::Surface bent = surface_of(sheet(1, [](float x, float z) { return x * z; }));
    EXPECT_EQ(hw::classes_at(bent, 3.2f).candidate_count(), 1u);
    EXPECT_EQ(wrong_edges_in_all_views(bent, true), 0u);
}

TEST(hard_meshes, coplanar_overlapping_faces)
{
    const hw::MeshData one = sheet(2, [](float, float) { return 0.0f; });
    const hw::Surface surface = surface_of(joined({one, one, turned_over(one)}));
    EXPECT_EQ(surface.faces.size(), one.triangle_count());
    EXPECT_EQ(surface.report.doubled_faces, 2 * one.triangle_count());
    EXPECT_EQ(wrong_edges_in_all_views(surface, true), 0u);
}

TEST(hard_meshes, self_intersecting_shells)
{
    const glm::mat4 shift = glm::translate(glm::mat4(1.0f), glm::vec3(0.5f, 0.1f, 0.0f));
    const hw::Surface surface = surface_of(joined({sphere(16, 12), moved(sphere(16, 12), shift)}));
    EXPECT_EQ(surface.report.closed_components, 2u);
    EXPECT_EQ(wrong_edges_in_all_views(surface, true), 0u);
}

TEST(hard_meshes, a_normal_that_is_zero_says_nothing)
{
    hw::MeshData mesh = flat_shaded(box({0, 0, 0}, {1, 1, 1}));
    for (glm::vec3& normal : mesh.normals) normal = glm::vec3(0.0f);
    EXPECT_EQ(surface_of(mesh).report.artist_edges, 0u);
}

TEST(hard_meshes, dihedral_exactly_at_the_threshold)
{
    // An edge folded by the crease angle itself is no crease; the next larger angle that counts makes it one.
    constexpr float kRightAngle = 1.57079633f;
    const hw::Surface surface = surface_of(box({0, 0, 0}, {1, 1, 1}));
    EXPECT_EQ(hw::classes_at(surface, kRightAngle).crease_count(), 0u);
    EXPECT_EQ(hw::classes_at(surface, kRightAngle).candidate_count(), 12u);
    EXPECT_EQ(hw::classes_at(surface, kRightAngle - 1e-5f).crease_count(), 12u);
    EXPECT_EQ(hw::classes_at(surface, kRightAngle - 1e-5f).candidate_count(), 0u);
}

TEST(hard_meshes, concavity_of_the_smallest_float_that_there_is)
{
    // The faces look at -y or +y; a step as small as floats can tell decides between ridge, flat and valley.
    const float tiny = std::numeric_limits<float>::min();
    const auto group_of = [](const hw::Surface& surface, hw::EdgeGroup group) {
        return surface.edges.group(group).size();
    };
    const hw::Surface flat = surface_of(flaps(0.0f)), up = surface_of(flaps(tiny)), down = surface_of(flaps(-tiny));
    EXPECT_EQ(group_of(flat, hw::EdgeGroup::reflex_silent), 1u);
    EXPECT_EQ(group_of(up, hw::EdgeGroup::reflex) + group_of(down, hw::EdgeGroup::reflex), 1u);
    EXPECT_EQ(group_of(up, hw::EdgeGroup::convex) + group_of(down, hw::EdgeGroup::convex), 1u);
    for (const hw::Surface* surface : {&flat, &up, &down}) EXPECT_EQ(wrong_edges_in_all_views(*surface, true), 0u);
}

TEST(hard_viewers, eye_in_the_plane_of_a_face)
{
    const hw::Surface surface = surface_of(box({0, 0, 0}, {1, 1, 1}));
    hw::SilhouetteScratch scratch;
    // In the plane x = 1, in front of z = 1: only that face looks at the eye.
    EXPECT_EQ(hw::all_silhouettes(surface, {glm::dvec3(1, 0.5, 3)}, {}, scratch).size(), 4u);
    EXPECT_EQ(wrong_edges_in_all_views(surface, true), 0u);
}

TEST(hard_viewers, eye_in_the_planes_of_both_faces_of_an_edge)
{
    const hw::Surface surface = surface_of(box({0, 0, 0}, {1, 1, 1}));
    hw::SilhouetteScratch scratch;
    EXPECT_EQ(hw::all_silhouettes(surface, {glm::dvec3(1, 1, 3)}, {}, scratch).size(), 4u);
    const hw::SilhouetteOracle oracle(surface.positions, surface.faces, kRational);
    EXPECT_EQ(wrong_edges(surface, {glm::dvec3(1, 1, 3)}, oracle, scratch), 0u);
}

TEST(hard_viewers, eye_on_a_face_an_edge_a_vertex)
{
    const hw::Surface surface = surface_of(box({0, 0, 0}, {1, 1, 1}));
    hw::SilhouetteScratch scratch;
    for (const glm::dvec3& eye : {glm::dvec3(1, 0.25, 0.5), glm::dvec3(1, 1, 0.5), glm::dvec3(1, 1, 1)}) {
        EXPECT_TRUE(hw::all_silhouettes(surface, {eye}, {}, scratch).empty());
    }
}

TEST(hard_viewers, eye_inside_a_closed_mesh)
{
    const hw::Surface surface = surface_of(sphere(16, 12));
    hw::SilhouetteScratch scratch;
    EXPECT_TRUE(hw::all_silhouettes(surface, {glm::dvec3(0.1, 0.2, 0.1)}, {}, scratch).empty());
    const hw::Surface room = surface_of(turned_over(sphere(16, 12)));
    EXPECT_TRUE(hw::all_silhouettes(room, {glm::dvec3(0.1, 0.2, 0.1)}, {}, scratch).empty());
}

TEST(hard_viewers, a_far_away_and_a_tiny_eye)
{
    const hw::Surface surface = surface_of(torus(16, 10));
    const hw::SilhouetteOracle oracle(surface.positions, surface.faces, kRational);
    hw::SilhouetteScratch scratch;
    for (const double distance : {1e-50, 1e-20, 1e12, 1e30, 1e50}) {
        const hw::Viewpoint viewpoint{glm::dvec3(distance, 0.3 * distance, -0.7 * distance)};
        EXPECT_EQ(wrong_edges(surface, viewpoint, oracle, scratch), 0u) << "distance " << distance;
    }
}

TEST(hard_viewers, mirrored_and_non_uniform_transforms)
{
    const hw::Surface surface = surface_of(torus(16, 10));
    const hw::SilhouetteOracle oracle(surface.positions, surface.faces, kRational);
    glm::dmat4 matrix = glm::scale(glm::dmat4(1.0), glm::dvec3(-2.0, 0.01, 30.0));
    matrix = glm::rotate(matrix, 0.8, glm::dvec3(0.2, 0.9, 0.1));
    hw::SilhouetteScratch scratch;
    const hw::Viewpoint viewpoint = hw::in_object({glm::dvec3(4.0, 5.0, 6.0)}, matrix);
    EXPECT_EQ(wrong_edges(surface, viewpoint, oracle, scratch), 0u);
}

TEST(hard_viewers, orthographic_views_parallel_to_faces_and_edges)
{
    const hw::Surface block = surface_of(box({-1, -2, -3}, {4, 5, 6}));
    const hw::SilhouetteOracle oracle(block.positions, block.faces, hw::SilhouetteOracle::Arithmetic::rational_only);
    hw::SilhouetteScratch scratch;
    for (int i = 0; i < 27; ++i) {
        const hw::Viewpoint view{glm::dvec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1), true};
        EXPECT_EQ(wrong_edges(block, view, oracle, scratch), 0u) << "direction " << i;
    }
}

TEST(hard_viewers, orthographic_along_the_plane_of_every_face)
{
    const hw::Surface surface = surface_of(torus(16, 10));
    const hw::SilhouetteOracle oracle(surface.positions, surface.faces, kRational);
    hw::SilhouetteScratch scratch;
    for (const auto& [a, b, c] : surface.faces) {
        const glm::dvec3 side = glm::dvec3(surface.positions[b]) - glm::dvec3(surface.positions[a]);
        EXPECT_EQ(wrong_edges(surface, {side, true}, oracle, scratch), 0u);
    }
}

TEST(hard_viewers, eye_on_every_vertex_and_edge_and_face_of_a_curved_mesh)
{
    const hw::Surface surface = surface_of(torus(12, 8));
    const hw::SilhouetteOracle oracle(surface.positions, surface.faces, kRational);
    hw::SilhouetteScratch scratch;
    for (const auto& corners : surface.faces) {
        const glm::dvec3 a = surface.positions[corners[0]], b = surface.positions[corners[1]],
                         c = surface.positions[corners[2]];
        for (const glm::dvec3& eye : {a, 0.5 * (a + b), 0.25 * a + 0.5 * b + 0.25 * c}) {
            EXPECT_EQ(wrong_edges(surface, {eye}, oracle, scratch), 0u);
        }
    }
}

TEST(hard_viewers, a_singular_transform_makes_no_eye)
{
    const glm::dmat4 flat = glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, 0.0, 1.0));
    EXPECT_EQ(hw::in_object({glm::dvec3(4.0, 5.0, 6.0)}, flat).eye, glm::dvec3(0.0));
}

TEST(hard_viewers, mixed_scales_in_one_mesh)
{
    const hw::MeshData mixed =
        joined({box({0, 0, 0}, {1e-6f, 1e-6f, 1e-6f}), box({-1e6f, -1e6f, -1e6f}, {-1, -1, -1})});
    EXPECT_EQ(wrong_edges_in_all_views(hw::build_surface(mixed, {.stitch_share = 0.0f, .cluster_from_faces = 1}), true),
              0u);
}
