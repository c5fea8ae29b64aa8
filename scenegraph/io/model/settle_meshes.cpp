#include "hatchway/io/model/settle_meshes.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numeric>

#include "hatchway/geometry/topology/mesh_faults.hpp"

namespace hw {
namespace {

/// From so many diagonals away on a mesh is far from its origin. The difference of two floats that are so close to each
/// other is a float.
constexpr double kFar = 256.0;

/// For each mesh whether all objects that show it show both sides of its faces.
std::vector<char> double_sided_meshes(const Scene& scene)
{
    std::vector<char> result(scene.meshes.size(), 1);
    for (const Object& object : scene.objects)
        if (!scene.materials[object.material].is_double_sided) result[object.mesh] = 0;
    return result;
}

/// Where a mesh is moved from; zero along axes where it is near enough. A multiple of a power of two well above its
/// size: meshes of one site are moved alike, and strokes, which stand at such multiples, stay where they are on them.
glm::vec3 far_origin(const MeshData& mesh)
{
    Box box;
    for (const glm::vec3& position : mesh.positions) box.add(glm::dvec3(position));
    glm::vec3 origin(0.0f);
    if (box.is_empty()) return origin;
    const double diagonal = glm::length(box.size());
    const double step = std::exp2(std::ceil(std::log2(std::max(8.0 * diagonal, 1e-30))));
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(box.centre()[axis]) > kFar * diagonal)
            origin[axis] = static_cast<float>(step * std::round(box.centre()[axis] / step));
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
    std::vector<std::uint32_t> turned(scene.meshes.size()), left_out(scene.meshes.size());
    const std::vector<char> is_double_sided = double_sided_meshes(scene);
    tbb::parallel_for(std::size_t{0}, scene.meshes.size(), [&](std::size_t i) {
        MeshData& mesh = scene.meshes[i];
        MeshFaults faults = find_mesh_faults(mesh);
        if (is_double_sided[i] != 0 && !faults.doubled.empty()) {
            leave_out(mesh, faults.doubled);
            left_out[i] = static_cast<std::uint32_t>(faults.doubled.size());
            faults = find_mesh_faults(mesh);
        }
        turn_over(mesh, faults.wrongly_wound);
        turned[i] = static_cast<std::uint32_t>(faults.wrongly_wound.size());
        if (is_double_sided[i] != 0) turn_over(mesh, faults.of_turned_sheets);
        origins[i] = bring_near(mesh);
    });
    scene.turned_triangles = std::accumulate(turned.begin(), turned.end(), 0u);
    scene.left_out_triangles = std::accumulate(left_out.begin(), left_out.end(), 0u);
    for (Object& object : scene.objects) {
        const glm::dvec3 origin(origins[object.mesh]);
        if (origin == glm::dvec3(0.0)) continue;
        object.place = static_cast<int>(scene.places.size());
        scene.places.push_back(glm::translate(scene.nodes[object.node].world_from_node, origin));
    }
}

}  // namespace hw
