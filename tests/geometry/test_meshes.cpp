#include "tests/geometry/test_meshes.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

namespace hw::test {
namespace {

glm::vec3 on_circle(int step, int steps, float radius, float y)
{
    const double angle = 2.0 * glm::pi<double>() * (step % steps) / steps;
    return {static_cast<float>(radius * std::cos(angle)), y, static_cast<float>(radius * std::sin(angle))};
}

void add_quad(MeshData& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
{
    for (const std::uint32_t index : {a, b, c, a, c, d}) mesh.indices.push_back(index);
}

}  // namespace

MeshData mesh_of(std::vector<glm::vec3> positions, std::vector<std::uint32_t> indices)
{
    MeshData mesh;
    mesh.positions = std::move(positions);
    mesh.indices = std::move(indices);
    return mesh;
}

MeshData prism(int sides)
{
    MeshData mesh;
    const auto n = static_cast<std::uint32_t>(sides);
    for (int level = 0; level < 2; ++level) {
        for (int i = 0; i < sides; ++i) mesh.positions.push_back(on_circle(i, sides, 1.0f, static_cast<float>(level)));
    }
    for (std::uint32_t i = 0; i < n; ++i) add_quad(mesh, i, i + n, (i + 1) % n + n, (i + 1) % n);
    for (std::uint32_t i = 1; i + 1 < n; ++i) {
        for (const std::uint32_t index : {0u, i, i + 1, n, n + i + 1, n + i}) mesh.indices.push_back(index);
    }
    return mesh;
}

MeshData box(const glm::vec3& low, const glm::vec3& high)
{
    MeshData mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.positions.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
    }
    add_quad(mesh, 0, 4, 6, 2);
    add_quad(mesh, 1, 3, 7, 5);
    add_quad(mesh, 0, 1, 5, 4);
    add_quad(mesh, 2, 6, 7, 3);
    add_quad(mesh, 0, 2, 3, 1);
    add_quad(mesh, 4, 5, 7, 6);
    return mesh;
}

MeshData sphere(int segments, int rings, float radius)
{
    MeshData mesh;
    const auto n = static_cast<std::uint32_t>(segments);
    mesh.positions.push_back({0.0f, radius, 0.0f});
    for (int ring = 1; ring < rings; ++ring) {
        const double angle = glm::pi<double>() * ring / rings;
        for (int i = 0; i < segments; ++i) {
            mesh.positions.push_back(on_circle(i, segments, static_cast<float>(radius * std::sin(angle)),
                                               static_cast<float>(radius * std::cos(angle))));
        }
    }
    mesh.positions.push_back({0.0f, -radius, 0.0f});
    const auto at = [&](int ring, std::uint32_t i) { return 1 + static_cast<std::uint32_t>(ring - 1) * n + i % n; };
    const auto bottom = static_cast<std::uint32_t>(mesh.positions.size() - 1);
    for (std::uint32_t i = 0; i < n; ++i) {
        for (const std::uint32_t index : {0u, at(1, i + 1), at(1, i)}) mesh.indices.push_back(index);
        for (int ring = 1; ring + 1 < rings; ++ring) {
            add_quad(mesh, at(ring, i), at(ring, i + 1), at(ring + 1, i + 1), at(ring + 1, i));
        }
        for (const std::uint32_t index : {bottom, at(rings - 1, i), at(rings - 1, i + 1)}) {
            mesh.indices.push_back(index);
        }
    }
    return mesh;
}

MeshData torus(int major, int minor, float major_radius, float minor_radius)
{
    MeshData mesh;
    for (int i = 0; i < major; ++i) {
        for (int j = 0; j < minor; ++j) {
            const double angle = 2.0 * glm::pi<double>() * j / minor;
            const auto distance = static_cast<float>(major_radius + minor_radius * std::cos(angle));
            mesh.positions.push_back(on_circle(i, major, distance, static_cast<float>(minor_radius * std::sin(angle))));
        }
    }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i % major * minor + j % minor); };
    for (int i = 0; i < major; ++i) {
        for (int j = 0; j < minor; ++j) add_quad(mesh, at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
    }
    return mesh;
}

MeshData sheet(int cells, const std::function<float(float, float)>& height)
{
    MeshData mesh;
    const auto n = static_cast<std::uint32_t>(cells + 1);
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = 0; j < n; ++j) {
            const float x = static_cast<float>(i) / cells, z = static_cast<float>(j) / cells;
            mesh.positions.push_back({x, height(x, z), z});
        }
    }
    for (std::uint32_t i = 0; i + 1 < n; ++i) {
        for (std::uint32_t j = 0; j + 1 < n; ++j) {
            add_quad(mesh, i * n + j, i * n + j + 1, (i + 1) * n + j + 1, (i + 1) * n + j);
        }
    }
    return mesh;
}

MeshData moebius_strip(int segments)
{
    MeshData mesh;
    for (int i = 0; i < segments; ++i) {
        const double turn = 2.0 * glm::pi<double>() * i / segments;
        for (const double side : {-0.3, 0.3}) {
            const double distance = 1.0 + side * std::cos(0.5 * turn);
            mesh.positions.push_back(
                glm::vec3(distance * std::cos(turn), side * std::sin(0.5 * turn), distance * std::sin(turn)));
        }
    }
    const auto n = static_cast<std::uint32_t>(segments);
    for (std::uint32_t i = 0; i < n; ++i) {
        const bool is_last = i + 1 == n;
        add_quad(mesh, 2 * i, 2 * i + 1, is_last ? 0 : 2 * i + 3, is_last ? 1 : 2 * i + 2);
    }
    return mesh;
}

MeshData klein_bottle(int major, int minor)
{
    MeshData mesh;
    for (int i = 0; i < major; ++i) {
        const double u = 2.0 * glm::pi<double>() * i / major;
        for (int j = 0; j < minor; ++j) {
            const double v = 2.0 * glm::pi<double>() * j / minor;
            const double r = 2.0 + std::cos(0.5 * u) * std::sin(v) - std::sin(0.5 * u) * std::sin(2.0 * v);
            mesh.positions.push_back(
                glm::vec3(r * std::cos(u), r * std::sin(u),
                          std::sin(0.5 * u) * std::sin(v) + std::cos(0.5 * u) * std::sin(2.0 * v)));
        }
    }
    // After one turn v has become -v.
    const auto at = [&](int i, int j) {
        const int k = i == major ? (2 * minor - j) % minor : j % minor;
        return static_cast<std::uint32_t>(i % major * minor + k);
    };
    for (int i = 0; i < major; ++i) {
        for (int j = 0; j < minor; ++j) add_quad(mesh, at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
    }
    return mesh;
}

MeshData joined(std::initializer_list<MeshData> meshes)
{
    MeshData all;
    for (const MeshData& mesh : meshes) {
        const auto first = static_cast<std::uint32_t>(all.positions.size());
        all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
        for (const std::uint32_t index : mesh.indices) all.indices.push_back(first + index);
    }
    return all;
}

MeshData turned_over(MeshData mesh)
{
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    return mesh;
}

MeshData moved(MeshData mesh, const glm::mat4& matrix)
{
    for (glm::vec3& p : mesh.positions) p = glm::vec3(matrix * glm::vec4(p, 1.0f));
    return mesh;
}

MeshData flat_shaded(const MeshData& mesh)
{
    MeshData flat;
    flat.has_own_normals = true;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
                        c = mesh.positions[mesh.indices[i + 2]];
        for (const glm::vec3& p : {a, b, c}) {
            flat.indices.push_back(static_cast<std::uint32_t>(flat.positions.size()));
            flat.positions.push_back(p);
            flat.normals.push_back(glm::normalize(glm::cross(b - a, c - a)));
        }
    }
    return flat;
}

}  // namespace hw::test
