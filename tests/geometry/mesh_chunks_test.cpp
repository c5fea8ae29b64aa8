#include "hatchway/geometry/mesh_chunks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>

namespace hw {
namespace {

MeshData triangle_soup(int count)
{
    std::mt19937 engine(7);
    std::uniform_real_distribution<float> place(0.0f, 10.0f);
    MeshData mesh;
    for (int i = 0; i < 3 * count; ++i) {
        mesh.positions.emplace_back(place(engine), place(engine), place(engine));
        mesh.indices.push_back(static_cast<std::uint32_t>(i));
    }
    return mesh;
}

std::multiset<std::array<std::uint32_t, 3>> triangles_of(const MeshData& mesh)
{
    std::multiset<std::array<std::uint32_t, 3>> result;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        result.insert({mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
    }
    return result;
}

TEST(mesh_chunks, every_triangle_is_in_one_chunk_and_keeps_its_corners)
{
    MeshData mesh = triangle_soup(5000);
    const auto before = triangles_of(mesh);
    const MeshChunks chunks = split_into_chunks(mesh);
    EXPECT_EQ(triangles_of(mesh), before);
    std::uint32_t next = 0;
    for (const MeshChunk& chunk : chunks) {
        EXPECT_EQ(chunk.first_index, next);
        EXPECT_GT(chunk.index_count, 0u);
        EXPECT_LE(chunk.index_count, 3 * kMaxChunkTriangles);
        next += chunk.index_count;
    }
    EXPECT_EQ(next, mesh.indices.size());
}

TEST(mesh_chunks, bounds_hold_every_corner)
{
    MeshData mesh = triangle_soup(1000);
    for (const MeshChunk& chunk : split_into_chunks(mesh)) {
        for (std::uint32_t i = 0; i < chunk.index_count; ++i) {
            Box corner;
            corner.add(glm::dvec3(mesh.positions[mesh.indices[chunk.first_index + i]]));
            EXPECT_TRUE(chunk.bounds_object.overlaps(corner));
        }
    }
}

TEST(mesh_chunks, a_small_mesh_is_one_chunk_in_its_own_order)
{
    MeshData mesh = triangle_soup(static_cast<int>(kMaxChunkTriangles));
    const auto before = mesh.indices;
    EXPECT_EQ(split_into_chunks(mesh).size(), 1u);
    EXPECT_EQ(mesh.indices, before);
}

TEST(mesh_chunks, an_empty_mesh_has_none)
{
    MeshData mesh;
    EXPECT_TRUE(split_into_chunks(mesh).empty());
}

TEST(mesh_chunks, equal_centres_still_give_the_same_order_each_time)
{
    MeshData mesh = triangle_soup(1);
    mesh.indices.clear();
    for (int i = 0; i < 1000; ++i) mesh.indices.insert(mesh.indices.end(), {0, 1, 2});
    MeshData again = mesh;
    split_into_chunks(mesh);
    const MeshChunks chunks = split_into_chunks(again);
    EXPECT_EQ(mesh.indices, again.indices);
    EXPECT_GE(chunks.size(), 4u);
}

TEST(mesh_chunks, chunks_are_spatial)
{
    MeshData mesh = triangle_soup(0);
    for (int i = 0; i < 2000; ++i) {
        const float x = static_cast<float>(i * 7919 % 2000);
        const std::uint32_t first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
        mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2});
    }
    for (const MeshChunk& chunk : split_into_chunks(mesh)) EXPECT_LE(chunk.bounds_object.size().x, 260.0);
}

}  // namespace
}  // namespace hw
