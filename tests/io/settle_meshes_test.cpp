#include "hatchway/io/model/settle_meshes.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace {

hw::MeshData box(const glm::vec3& low, const glm::vec3& high)
{
    hw::MeshData mesh;
    for (int i = 0; i < 8; ++i)
        mesh.positions.emplace_back(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    mesh.indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                    2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    return mesh;
}

/// The same mesh, shown by one node for each matrix.
hw::Scene scene_of(const hw::MeshData& mesh, const std::vector<glm::dmat4>& places)
{
    hw::Scene scene;
    scene.meshes.push_back(mesh);
    scene.materials.emplace_back();
    for (const glm::dmat4& place : places) {
        scene.objects.push_back({.node = static_cast<int>(scene.nodes.size()), .mesh = 0, .material = 0});
        scene.nodes.push_back({.world_from_node = place});
    }
    return scene;
}

glm::dvec3 world_place(const hw::Scene& scene, hw::ObjectId id, std::size_t vertex)
{
    const hw::MeshData& mesh = scene.meshes[scene.objects[id].mesh];
    return glm::dvec3(scene.world_from_object(id) * glm::dvec4(glm::dvec3(mesh.positions[vertex]), 1.0));
}

}  // namespace

TEST(settle_meshes, turned_triangles_are_turned_back_whatever_the_matrices_mirror)
{
    hw::MeshData mesh = box({-1, -1, -1}, {1, 1, 1});
    std::swap(mesh.indices[4], mesh.indices[5]);
    hw::Scene scene = scene_of(mesh, {glm::dmat4(1.0), glm::scale(glm::dmat4(1.0), glm::dvec3(-1, 1, 1))});
    hw::settle_meshes(scene);
    EXPECT_EQ(scene.turned_triangles, 1u);
    EXPECT_EQ(scene.meshes[0].indices, box({-1, -1, -1}, {1, 1, 1}).indices);
}

TEST(settle_meshes, what_is_shown_from_both_sides_has_no_triangle_twice)
{
    const hw::MeshData one = box({-1, -1, -1}, {1, 1, 1});
    hw::MeshData both = one;
    for (std::size_t i = 0; i < one.indices.size(); i += 3)
        both.indices.insert(both.indices.end(), {one.indices[i + 2], one.indices[i + 1], one.indices[i]});
    hw::Scene scene = scene_of(both, {glm::dmat4(1.0), glm::dmat4(1.0)});
    hw::settle_meshes(scene);
    EXPECT_EQ(scene.meshes[0].indices, both.indices) << "each culls the other";
    EXPECT_EQ(scene.left_out_triangles, 0u);

    scene = scene_of(both, {glm::dmat4(1.0), glm::dmat4(1.0)});
    scene.materials[0].is_double_sided = true;
    hw::settle_meshes(scene);
    EXPECT_EQ(scene.meshes[0].indices, one.indices);
    EXPECT_EQ(scene.left_out_triangles, 12u);
}

TEST(settle_meshes, vertices_far_from_the_origin_are_brought_near_and_stay_where_they_are)
{
    for (const double far : {1e6, 8e6, -3e6}) {
        // Half metres are what floats hold at eight million.
        const glm::vec3 away(static_cast<float>(far), 0.0f, static_cast<float>(-0.5 * far));
        const hw::MeshData mesh = box(away, away + glm::vec3(6.0f, 2.5f, 4.0f));
        const glm::dmat4 turned =
            glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(3, -4, 1e5)), 0.7, glm::dvec3(1, 2, 3));
        const hw::Scene stated = scene_of(mesh, {glm::dmat4(1.0), turned});
        hw::Scene scene = stated;
        hw::settle_meshes(scene);
        for (const glm::vec3& p : scene.meshes[0].positions) EXPECT_LT(glm::length(p), 64.0f);
        for (hw::ObjectId id = 0; id < 2; ++id)
            for (std::size_t vertex = 0; vertex < 8; ++vertex)
                EXPECT_LT(glm::distance(world_place(scene, id, vertex), world_place(stated, id, vertex)), 1e-8);
    }
}

TEST(settle_meshes, what_is_near_is_left_alone)
{
    hw::Scene scene = scene_of(box({100, 0, 0}, {102, 3, 1}), {glm::dmat4(1.0)});
    const std::vector<glm::vec3> before = scene.meshes[0].positions;
    hw::settle_meshes(scene);
    EXPECT_EQ(scene.meshes[0].positions, before);
    EXPECT_TRUE(scene.places.empty());
}
