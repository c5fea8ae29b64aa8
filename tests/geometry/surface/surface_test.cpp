#include "hatchway/geometry/surface/surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "hatchway/geometry/surface/surface_faces.hpp"
#include "tests/geometry/test_meshes.hpp"

namespace {

using namespace hw::test;

constexpr float kSixtyDegrees = 1.0471976f;

std::uint32_t size_of(const hw::Surface& surface, hw::EdgeGroup group)
{
    return surface.edges.group(group).size();
}

}  // namespace

TEST(surface, the_prism_with_eight_sides_has_sixteen_creases_eight_candidates_and_eighteen_silent_edges)
{
    const hw::Surface surface = hw::build_surface(prism(8));
    EXPECT_EQ(surface.faces.size(), 28u);
    EXPECT_EQ(surface.edges.size(), 42u);
    const hw::EdgeClasses classes = hw::classes_at(surface, kSixtyDegrees);
    EXPECT_EQ(classes.crease_count(), 16u);
    EXPECT_EQ(classes.candidate_count(), 8u);
    EXPECT_EQ(classes.silent.size(), 18u);
    EXPECT_EQ(classes.borders.size(), 0u);
}

TEST(surface, a_flat_shaded_prism_has_the_same_classes)
{
    const hw::Surface surface = hw::build_surface(flat_shaded(prism(8)));
    const hw::EdgeClasses classes = hw::classes_at(surface, kSixtyDegrees);
    EXPECT_EQ(classes.crease_count(), 16u);
    EXPECT_EQ(classes.candidate_count(), 8u);
    EXPECT_EQ(classes.silent.size(), 18u);
}

TEST(surface, any_crease_angle_is_a_prefix_of_every_group)
{
    const hw::Surface surface = hw::build_surface(torus(13, 9));
    for (int group = 1; group < hw::kEdgeGroupCount; ++group) {
        const hw::EdgeRange range = surface.edges.group(static_cast<hw::EdgeGroup>(group));
        for (std::uint32_t edge = range.begin + 1; edge < range.end; ++edge) {
            EXPECT_LE(hw::fold_rad(surface, edge), hw::fold_rad(surface, edge - 1));
        }
    }
    std::uint32_t last = 0;
    for (const float angle : {3.2f, 1.0f, 0.6f, 0.3f, 0.0f}) {
        const hw::EdgeClasses classes = hw::classes_at(surface, angle);
        EXPECT_GE(classes.crease_count(), last);
        EXPECT_EQ(classes.crease_count() + classes.candidate_count() + classes.silent.size(), surface.edges.size());
        last = classes.crease_count();
    }
}

TEST(surface, a_fold_of_exactly_the_crease_angle_is_no_crease)
{
    const hw::Surface straight = hw::build_surface(box({0, 0, 0}, {1, 2, 3}));
    EXPECT_EQ(hw::classes_at(straight, glm::half_pi<float>()).crease_count(), 0u);
    EXPECT_EQ(hw::classes_at(straight, glm::half_pi<float>() - 1e-4f).crease_count(), 12u);
    const glm::mat4 turn = glm::rotate(glm::mat4(1.0f), 0.7f, glm::vec3(0.3f, 0.5f, 0.8f));
    const hw::Surface turned = hw::build_surface(moved(box({0, 0, 0}, {1, 2, 3}), turn));
    EXPECT_EQ(hw::classes_at(turned, glm::half_pi<float>()).crease_count(), 0u);
}

TEST(surface, reflex_edges_are_silent_only_where_the_surface_is_closed_outward_and_solid)
{
    // The inside of a torus' ring is reflex along the minor circles.
    const hw::Surface solid = hw::build_surface(torus(24, 12));
    EXPECT_EQ(size_of(solid, hw::EdgeGroup::reflex), 0u);
    EXPECT_GT(size_of(solid, hw::EdgeGroup::reflex_silent), 0u);
    EXPECT_EQ(solid.report.reflex_rule_components, 1u);

    const hw::Surface walk_in = hw::build_surface(torus(24, 12), {.is_solid = false});
    EXPECT_EQ(size_of(walk_in, hw::EdgeGroup::reflex), size_of(solid, hw::EdgeGroup::reflex_silent));
    EXPECT_EQ(walk_in.report.reflex_rule_components, 0u);

    const hw::Surface room = hw::build_surface(turned_over(torus(24, 12)));
    EXPECT_EQ(room.report.inward_components, 1u);
    EXPECT_EQ(room.report.flipped_faces, 0u);
    EXPECT_EQ(size_of(room, hw::EdgeGroup::reflex_silent), 0u);

    hw::MeshData open = torus(24, 12);
    open.indices.resize(open.indices.size() - 3);
    EXPECT_GT(size_of(hw::build_surface(open), hw::EdgeGroup::reflex), 0u);
}

TEST(surface, the_minority_of_an_inconsistent_component_is_flipped)
{
    hw::MeshData mesh = sphere(12, 8);
    for (std::size_t triangle = 0; triangle < mesh.triangle_count(); triangle += 5) {
        std::swap(mesh.indices[3 * triangle], mesh.indices[3 * triangle + 1]);
    }
    const hw::Surface surface = hw::build_surface(mesh);
    EXPECT_EQ(surface.report.flipped_faces, (mesh.triangle_count() + 4) / 5);
    EXPECT_EQ(surface.report.inconsistent_edges, 0u);
    EXPECT_EQ(surface.report.closed_components, 1u);
    EXPECT_TRUE(surface.components[0].is_outward);
}

TEST(surface, one_flipped_face_is_the_one_that_is_turned_back_whichever_it_is)
{
    const hw::MeshData whole = sphere(6, 4);
    for (std::size_t triangle = 0; triangle < whole.triangle_count(); ++triangle) {
        hw::MeshData mesh = whole;
        std::swap(mesh.indices[3 * triangle], mesh.indices[3 * triangle + 1]);
        const hw::Surface surface = hw::build_surface(mesh);
        EXPECT_EQ(surface.report.flipped_faces, 1u);
        EXPECT_TRUE(surface.components[0].is_outward);
    }
}

TEST(surface, faces_with_two_equal_corners_are_removed_and_counted)
{
    hw::MeshData mesh = box({0, 0, 0}, {1, 1, 1});
    for (const std::uint32_t index : {0u, 0u, 1u}) mesh.indices.push_back(index);
    mesh.positions.push_back(mesh.positions[0]);
    for (const std::uint32_t index : {0u, 8u, 1u}) mesh.indices.push_back(index);
    const hw::Surface surface = hw::build_surface(mesh);
    EXPECT_EQ(surface.report.removed_faces, 2u);
    EXPECT_EQ(surface.report.closed_components, 1u);
}

TEST(surface, zero_and_minus_zero_are_one_position)
{
    hw::MeshData mesh = mesh_of({{0.0f, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0f, 0, 0}, {0, -1, 0}}, {0, 1, 2, 3, 4, 1});
    const hw::Surface surface = hw::build_surface(mesh);
    EXPECT_EQ(surface.edges.two_faced().size(), 1u);
}

TEST(surface, borders_within_a_hundred_thousandth_of_the_bounding_box_are_stitched)
{
    hw::MeshData mesh = sheet(8, [](float, float) { return 0.0f; });
    hw::MeshData next = moved(mesh, glm::translate(glm::mat4(1.0f), glm::vec3(1.000008f, 0, 0.000004f)));
    const hw::Surface near = hw::build_surface(joined({mesh, next}));
    EXPECT_EQ(near.report.stitched_edges, 8u);
    EXPECT_EQ(near.report.components, 1u);
    EXPECT_EQ(near.report.border_edges, 48u);

    next = moved(mesh, glm::translate(glm::mat4(1.0f), glm::vec3(1.0001f, 0, 0)));
    const hw::Surface far = hw::build_surface(joined({mesh, next}));
    EXPECT_EQ(far.report.stitched_edges, 0u);
    EXPECT_EQ(far.report.components, 2u);
}

TEST(surface, stitching_never_takes_a_corner_from_a_face)
{
    // Slivers narrower than the tolerance: their own sides must not be joined.
    hw::MeshData mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 5e-6f, 0}, {0, 5e-6f, 0}}, {0, 1, 2, 0, 2, 3});
    const hw::Surface surface = hw::build_surface(mesh);
    EXPECT_EQ(surface.faces.size(), 2u);
    for (const auto& face : surface.faces) {
        EXPECT_NE(face[0], face[1]);
        EXPECT_NE(face[1], face[2]);
        EXPECT_NE(face[2], face[0]);
    }
}

TEST(surface, split_normals_over_a_noticeable_fold_are_the_artists_edges)
{
    // A smooth sphere whose normals are split along its equator only.
    hw::MeshData mesh = sphere(16, 8);
    mesh.has_own_normals = true;
    mesh.normals = mesh.positions;
    const std::size_t count = mesh.positions.size();
    for (std::size_t i = 0; i < count; ++i) {
        mesh.positions.push_back(mesh.positions[i]);
        mesh.normals.push_back(glm::normalize(mesh.normals[i] - glm::vec3(0.0f, 0.3f, 0.0f)));
    }
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        float middle = 0.0f;
        for (int corner = 0; corner < 3; ++corner) middle += mesh.positions[mesh.indices[i + corner]].y;
        if (middle >= 0.0f) continue;
        for (int corner = 0; corner < 3; ++corner) mesh.indices[i + corner] += static_cast<std::uint32_t>(count);
    }
    const hw::Surface surface = hw::build_surface(mesh);
    EXPECT_EQ(surface.report.artist_edges, 16u);
    EXPECT_EQ(hw::classes_at(surface, 3.2f).crease_count(), 16u);
}

TEST(surface, flat_shading_all_over_marks_no_artists_edges)
{
    EXPECT_EQ(hw::build_surface(flat_shaded(sphere(16, 8))).report.artist_edges, 0u);
}

TEST(surface, edges_named_by_the_model_are_the_artists_whatever_their_fold)
{
    hw::MeshData mesh = sheet(2, [](float, float) { return 0.0f; });
    mesh.artist_edges = {4, 5, 5, 4, 0, 8};
    const hw::Surface surface = hw::build_surface(mesh);
    EXPECT_EQ(surface.report.artist_edges, 1u);
    EXPECT_EQ(hw::classes_at(surface, 1.0f).artist[1].size(), 1u);
}

TEST(surface, an_empty_mesh_gives_an_empty_surface)
{
    const hw::Surface surface = hw::build_surface(hw::MeshData());
    EXPECT_EQ(surface.edges.size(), 0u);
    EXPECT_EQ(surface.report.components, 0u);
}

TEST(surface, is_the_same_bit_by_bit_when_built_again)
{
    const hw::MeshData mesh = joined({torus(20, 10), sphere(9, 7, 3.0f), moebius_strip(30)});
    const hw::Surface a = hw::build_surface(mesh), b = hw::build_surface(mesh);
    EXPECT_EQ(a.edges.edges, b.edges.edges);
    EXPECT_EQ(a.faces, b.faces);
}

TEST(surface, takes_eight_bytes_an_edge_and_eight_a_face)
{
    const hw::Surface surface = hw::build_surface(torus(40, 20));
    const hw::OutlineBytes bytes = hw::outline_bytes(surface);
    EXPECT_EQ(bytes.edges, 8u * surface.edges.size());
    EXPECT_EQ(bytes.planes, 8u * surface.faces.size());
    EXPECT_EQ(bytes.clusters, 0u);
}

TEST(surface, edges_find_their_ends_and_faces)
{
    const hw::MeshData mesh = joined({torus(20, 10), sphere(9, 7, 3.0f), moebius_strip(30)});
    const hw::Surface surface = hw::build_surface(mesh);
    for (std::uint32_t edge = 0; edge < surface.edges.size(); ++edge) {
        const auto [from, to] = hw::edge_vertices(surface, edge);
        for (const std::uint32_t face : surface.edges[edge].faces()) {
            if (face == hw::kNoFace) continue;
            const auto corners = hw::face_corners(surface, face);
            EXPECT_EQ(std::count(corners.begin(), corners.end(), from), 1);
            EXPECT_EQ(std::count(corners.begin(), corners.end(), to), 1);
        }
    }
}
