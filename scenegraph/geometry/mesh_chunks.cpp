#include "hatchway/geometry/mesh_chunks.hpp"

#include <algorithm>
#include <array>
#include <glm/vec3.hpp>
#include <numeric>
#include <span>

namespace hw {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

glm::vec3 centre_of(const MeshData& mesh, const Triangle& triangle)
{
    // Thirds are taken first: the sum of three large floats could overflow.
    return mesh.positions[triangle[0]] / 3.0f + mesh.positions[triangle[1]] / 3.0f + mesh.positions[triangle[2]] / 3.0f;
}

int longest_axis(const Box& box)
{
    const glm::dvec3 size = box.size();
    if (size.x >= size.y && size.x >= size.z) return 0;
    return size.y >= size.z ? 1 : 2;
}

/// Sorts `order` (triangle numbers) so that every cut at `leaf_size` multiples of the halving is spatial.
void halve(std::span<std::uint32_t> order, const std::vector<glm::vec3>& centres, std::vector<std::uint32_t>& sizes)
{
    if (order.size() <= kMaxChunkTriangles) {
        // Inside of a chunk the artist's order stays: blended triangles rely on it.
        std::sort(order.begin(), order.end());
        sizes.push_back(static_cast<std::uint32_t>(order.size()));
        return;
    }
    Box bounds;
    for (const std::uint32_t triangle : order) bounds.add(glm::dvec3(centres[triangle]));
    const int axis = longest_axis(bounds);
    const auto middle = order.begin() + static_cast<std::ptrdiff_t>(order.size() / 2);
    std::nth_element(order.begin(), middle, order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return centres[a][axis] != centres[b][axis] ? centres[a][axis] < centres[b][axis] : a < b;
    });
    halve(order.first(order.size() / 2), centres, sizes);
    halve(order.subspan(order.size() / 2), centres, sizes);
}

MeshChunk make_chunk(const MeshData& mesh, std::uint32_t first_index, std::uint32_t index_count)
{
    MeshChunk chunk{first_index, index_count, {}};
    for (std::uint32_t i = 0; i < index_count; ++i) {
        chunk.bounds_object.add(glm::dvec3(mesh.positions[mesh.indices[first_index + i]]));
    }
    return chunk;
}

}  // namespace

MeshChunks split_into_chunks(MeshData& mesh)
{
    const std::size_t count = mesh.triangle_count();
    if (count == 0) return {};
    if (count <= kMaxChunkTriangles) return {make_chunk(mesh, 0, static_cast<std::uint32_t>(mesh.indices.size()))};

    std::vector<Triangle> triangles(count);
    std::vector<glm::vec3> centres(count);
    for (std::size_t i = 0; i < count; ++i) {
        triangles[i] = {mesh.indices[3 * i], mesh.indices[3 * i + 1], mesh.indices[3 * i + 2]};
        centres[i] = centre_of(mesh, triangles[i]);
    }
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    std::vector<std::uint32_t> sizes;
    halve(order, centres, sizes);
    for (std::size_t i = 0; i < count; ++i) {
        std::copy_n(triangles[order[i]].begin(), 3, mesh.indices.begin() + static_cast<std::ptrdiff_t>(3 * i));
    }

    MeshChunks chunks;
    std::uint32_t first = 0;
    for (const std::uint32_t size : sizes) {
        chunks.push_back(make_chunk(mesh, 3 * first, 3 * size));
        first += size;
    }
    return chunks;
}

}  // namespace hw
