#include "measure/silhouettes/half_edge_mesh.hpp"

#include <gtest/gtest.h>

#include "hatchway/geometry/silhouettes/silhouettes.hpp"
#include "tests/geometry/test_meshes.hpp"

namespace {

using namespace hw::test;

}  // namespace

TEST(half_edge_mesh, holds_every_face_of_a_manifold_without_new_vertices)
{
    const hw::Surface surface = hw::build_surface(torus(20, 10));
    const hw::HalfEdgeMesh mesh(surface);
    EXPECT_EQ(mesh.face_count(), surface.faces.size());
    EXPECT_EQ(mesh.edge_count(), surface.edges.size());
    EXPECT_EQ(mesh.refused_faces(), 0u);
}

TEST(half_edge_mesh, loses_no_face_where_openmesh_refuses_one)
{
    const hw::MeshData two_boxes = joined({box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1})});
    for (const hw::MeshData& mesh : {two_boxes, moebius_strip(20), klein_bottle(16, 12)}) {
        const hw::Surface surface = hw::build_surface(mesh);
        const hw::HalfEdgeMesh half_edges(surface);
        EXPECT_EQ(half_edges.face_count(), surface.faces.size());
        EXPECT_EQ(half_edges.face_count(), mesh.triangle_count());
        EXPECT_GT(half_edges.refused_faces(), 0u);
        EXPECT_EQ(half_edges.vertex_count(), surface.positions.size() + 3 * half_edges.refused_faces());
    }
}

TEST(half_edge_mesh, both_of_its_loops_find_as_many_silhouettes_as_ours_from_a_harmless_eye)
{
    const hw::Surface surface = hw::build_surface(torus(40, 20));
    hw::HalfEdgeMesh mesh(surface);
    const hw::Viewpoint eye{glm::dvec3(3.1, 2.3, 1.7)};
    hw::SilhouetteScratch scratch;
    const std::size_t ours = hw::all_silhouettes(surface, eye, {}, scratch).size();
    std::vector<int> plain, kept;
    mesh.plain_silhouettes(eye, plain);
    mesh.kept_facing_silhouettes(eye, kept);
    EXPECT_GT(ours, 50u);
    EXPECT_EQ(plain.size(), ours);
    EXPECT_EQ(kept, plain);
}
