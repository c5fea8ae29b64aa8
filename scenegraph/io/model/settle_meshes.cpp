#include "hatchway/io/model/settle_meshes.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numeric>

#include "hatchway/geometry/topology/repaired_mesh.hpp"

namespace hw {
namespace {

/// From so many diagonals away on a mesh is far from its origin. The difference of two floats that are so close to each
/// other is a float.
constexpr double kFar = 256.0;

/// Where a mesh is moved from; zero along axes where it is near enough.
glm::vec3 far_origin(const MeshData& mesh)
{
    Box box;
    for (const glm::vec3& position : mesh.positions) box.add(glm::dvec3(position));
    glm::vec3 origin(0.0f);
    if (box.is_empty()) return origin;
    const double diagonal = glm::length(box.size());
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(box.centre()[axis]) > kFar * diagonal) origin[axis] = static_cast<float>(box.centre()[axis]);
    return origin;
}

/// Returns where it was.
glm::vec3 bring_near(MeshData& mesh)
{
    const glm::vec3 origin = far_origin(mesh);
    if (origin != glm::vec3(0.0f))
        for (glm::vec3& position : mesh.positions) position -= origin;
    return origin;
}

}  // namespace

void settle_meshes(Scene& scene)
{
    std::vector<glm::vec3> origins(scene.meshes.size());
    std::vector<std::uint32_t> turned(scene.meshes.size());
    tbb::parallel_for(std::size_t{0}, scene.meshes.size(), [&](std::size_t i) {
        const std::vector<std::uint32_t> triangles = wrongly_wound_triangles(scene.meshes[i]);
        turn_over(scene.meshes[i], triangles);
        turned[i] = static_cast<std::uint32_t>(triangles.size());
        origins[i] = bring_near(scene.meshes[i]);
    });
    scene.turned_triangles = std::accumulate(turned.begin(), turned.end(), 0u);
    for (Object& object : scene.objects) {
        const glm::dvec3 origin(origins[object.mesh]);
        if (origin == glm::dvec3(0.0)) continue;
        object.place = static_cast<int>(scene.places.size());
        scene.places.push_back(glm::translate(scene.nodes[object.node].world_from_node, origin));
    }
}

}  // namespace hw
