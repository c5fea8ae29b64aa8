#pragma once

#include <functional>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <initializer_list>

#include "hatchway/geometry/mesh_data.hpp"

namespace hw::test {

/// A mesh of bare triangles.
MeshData mesh_of(std::vector<glm::vec3> positions, std::vector<std::uint32_t> indices);

/// The paper's prism: 4 (sides - 1) triangles, radius and height 1, around the y axis.
MeshData prism(int sides);

MeshData box(const glm::vec3& low, const glm::vec3& high);

/// A closed sphere of 2 x segments x (rings - 1) triangles.
MeshData sphere(int segments, int rings, float radius = 1.0f);

/// A closed torus of 2 x major x minor triangles.
MeshData torus(int major, int minor, float major_radius = 1.0f, float minor_radius = 0.4f);

/// A grid of quads over [0, 1] x [0, 1], with the height y(x, z).
MeshData sheet(int cells, const std::function<float(float, float)>& height);

MeshData moebius_strip(int segments);
MeshData klein_bottle(int major, int minor);

MeshData joined(std::initializer_list<MeshData> meshes);
MeshData turned_over(MeshData mesh);
MeshData moved(MeshData mesh, const glm::mat4& matrix);

/// Every triangle with corners of its own and the normal of its face.
MeshData flat_shaded(const MeshData& mesh);

}  // namespace hw::test
