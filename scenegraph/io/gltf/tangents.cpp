#include "hatchway/io/gltf/tangents.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <span>

#include "hatchway/geometry/vertex_streams.hpp"

namespace hw {
namespace {

/// The direction in which u grows on a triangle, weighted by the triangle's size in texture space.
struct Gradients {
    glm::vec3 u{0.0f};
    bool is_mirrored = false;  ///< The image reads as in a mirror. v grows downwards, so an area below 0 is the usual.
    bool is_usable = false;
};

Gradients gradients_of(const MeshData& mesh, std::span<const glm::vec2> uv, std::size_t triangle)
{
    const std::uint32_t* corner = &mesh.indices[3 * triangle];
    const glm::vec3 p1 = mesh.positions[corner[1]] - mesh.positions[corner[0]];
    const glm::vec3 p2 = mesh.positions[corner[2]] - mesh.positions[corner[0]];
    const glm::vec2 t1 = uv[corner[1]] - uv[corner[0]];
    const glm::vec2 t2 = uv[corner[2]] - uv[corner[0]];
    const float area = t1.x * t2.y - t2.x * t1.y;
    Gradients gradients;
    gradients.is_mirrored = area > 0.0f;
    gradients.u = (p1 * t2.y - p2 * t1.y) * (area < 0.0f ? -1.0f : 1.0f);
    const float length = glm::length(gradients.u);
    gradients.is_usable = area != 0.0f && std::isfinite(length) && length > 0.0f;
    return gradients;
}

glm::vec3 any_direction_across(const glm::vec3& normal)
{
    const glm::vec3 axis = std::abs(normal.x) < 0.5f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
    return glm::normalize(axis - normal * glm::dot(axis, normal));
}

glm::vec4 tangent_of(const glm::vec3& normal, const glm::vec3& sum, bool is_mirrored)
{
    const glm::vec3 across = sum - normal * glm::dot(normal, sum);
    const float length = glm::length(across);
    const bool is_usable = std::isfinite(length) && length > 0.0f;
    return {is_usable ? across / length : any_direction_across(normal), is_mirrored ? -1.0f : 1.0f};
}

std::vector<glm::vec2> sampled_coordinates(const MeshData& mesh, const TextureUse& use)
{
    std::vector<glm::vec2> uv = use.uv_set == 0 ? mesh.uv0 : mesh.uv1;
    for (glm::vec2& place : uv) place = glm::vec2(use.uv_transform * glm::vec3(place, 1.0f));
    return uv;
}

/// A copy of a vertex for the mirrored side of a seam.
std::uint32_t double_vertex(MeshData& mesh, std::uint32_t vertex)
{
    for_each_stream(mesh, [&](auto& stream) {
        if (stream.empty()) return;
        const auto value = stream[vertex];
        stream.push_back(value);
    });
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

enum Side : std::uint8_t { unknown = 0, straight = 1, mirrored = 2, both = 3 };

/// Doubles the vertices that both straight and mirrored triangles use, and lets the latter use the copies.
void split_mirrored(MeshData& mesh, std::span<const Gradients> gradients)
{
    std::vector<std::uint8_t> sides(mesh.positions.size(), unknown);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i)
        if (gradients[i / 3].is_usable) sides[mesh.indices[i]] |= gradients[i / 3].is_mirrored ? mirrored : straight;
    std::vector<std::uint32_t> copies(mesh.positions.size(), 0);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        std::uint32_t& vertex = mesh.indices[i];
        if (!gradients[i / 3].is_usable || !gradients[i / 3].is_mirrored || sides[vertex] != both) continue;
        if (copies[vertex] == 0) copies[vertex] = double_vertex(mesh, vertex);
        vertex = copies[vertex];
    }
}

}  // namespace

void add_tangents(MeshData& mesh, const TextureUse& use)
{
    if (!mesh.tangents.empty()) return;
    const std::vector<glm::vec2> uv = sampled_coordinates(mesh, use);
    if (uv.empty()) return;
    std::vector<Gradients> gradients;
    gradients.reserve(mesh.triangle_count());
    for (std::size_t i = 0; i < mesh.triangle_count(); ++i) gradients.push_back(gradients_of(mesh, uv, i));
    split_mirrored(mesh, gradients);

    std::vector<glm::vec3> sums(mesh.positions.size());
    std::vector<bool> is_mirrored(mesh.positions.size(), false);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        if (!gradients[i / 3].is_usable) continue;
        sums[mesh.indices[i]] += gradients[i / 3].u;
        is_mirrored[mesh.indices[i]] = gradients[i / 3].is_mirrored;
    }
    mesh.tangents.reserve(sums.size());
    for (std::size_t i = 0; i < sums.size(); ++i)
        mesh.tangents.push_back(tangent_of(mesh.normals[i], sums[i], is_mirrored[i]));
}

}  // namespace hw
