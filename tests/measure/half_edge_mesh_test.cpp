#include "measure/silhouettes/half_edge_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "hatchway/geometry/silhouettes/silhouettes.hpp"
#include "tests/geometry/test_meshes.hpp"

namespace {

using namespace hw::test;

using EdgeSet = std::set<std::array<std::uint32_t, 2>>;

std::array<std::uint32_t, 2> edge_between(const std::array<std::uint32_t, 2>& ends)
{
    return {std::min(ends[0], ends[1]), std::max(ends[0], ends[1])};
}

EdgeSet edges_of(const hw::HalfEdgeMesh& mesh, const std::vector<int>& edges)
{
    EdgeSet set;
    for (const int edge : edges) set.insert(edge_between(mesh.edge_ends(edge)));
    return set;
}

/// The same mesh, its vertices and its triangles in another order.
hw::MeshData shuffled(const hw::MeshData& mesh)
{
    std::mt19937 random(7);
    const auto order_of = [&](std::size_t count) {
        std::vector<std::uint32_t> order(count);
        std::iota(order.begin(), order.end(), 0u);
        std::shuffle(order.begin(), order.end(), random);
        return order;
    };
    const std::vector<std::uint32_t> place = order_of(mesh.positions.size());
    hw::MeshData result;
    result.positions.resize(mesh.positions.size());
    for (std::size_t i = 0; i < place.size(); ++i) result.positions[place[i]] = mesh.positions[i];
    for (const std::uint32_t triangle : order_of(mesh.triangle_count()))
        for (std::size_t corner = 0; corner < 3; ++corner)
            result.indices.push_back(place[mesh.indices[3 * triangle + corner]]);
    return result;
}

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

TEST(half_edge_mesh, both_of_its_loops_find_the_same_edges_as_ours_from_a_harmless_eye_in_any_order_of_the_file)
{
    const hw::MeshData model = torus(40, 20);
    for (const hw::MeshData& mesh : {model, shuffled(model)}) {
        const hw::Surface surface = hw::build_surface(mesh);
        hw::HalfEdgeMesh half_edges(surface);
        const hw::Viewpoint eye{glm::dvec3(3.1, 2.3, 1.7)};
        hw::SilhouetteScratch scratch;
        EdgeSet ours;
        for (const std::uint32_t edge : hw::all_silhouettes(surface, eye, {}, scratch))
            ours.insert(edge_between(hw::edge_vertices(surface, edge)));
        std::vector<int> plain, kept;
        half_edges.plain_silhouettes(eye, plain);
        half_edges.kept_facing_silhouettes(eye, kept);
        EXPECT_GT(ours.size(), 50u);
        EXPECT_TRUE(edges_of(half_edges, plain) == ours);
        EXPECT_TRUE(edges_of(half_edges, kept) == ours);
    }
}

TEST(half_edge_mesh, names_the_edges_of_the_surface_also_where_openmesh_refuses_faces)
{
    const hw::Surface surface = hw::build_surface(shuffled(klein_bottle(16, 12)));
    const hw::HalfEdgeMesh mesh(surface);
    EdgeSet all;
    for (std::uint32_t edge = 0; edge < surface.edges.size(); ++edge)
        all.insert(edge_between(hw::edge_vertices(surface, edge)));
    std::vector<int> edges(mesh.edge_count());
    std::iota(edges.begin(), edges.end(), 0);
    EXPECT_GT(mesh.refused_faces(), 0u);
    EXPECT_TRUE(edges_of(mesh, edges) == all);
}
