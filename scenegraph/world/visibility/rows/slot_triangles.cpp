#include "hatchway/world/visibility/rows/slot_triangles.hpp"

#include <algorithm>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

namespace hw {

std::vector<SlotTriangle> slot_triangles(const SlotPlaces& places, std::uint32_t slot)
{
    const Object& object = places.scene.objects[places.slots[slot].object];
    const std::size_t mesh_index = static_cast<std::size_t>(object.mesh);
    const MeshData& mesh = places.scene.meshes[mesh_index];
    const MeshChunk& chunk = places.chunks_of_mesh[mesh_index][places.slots[slot].chunk];
    const glm::dmat4& matrix = places.scene.world_from_object(places.slots[slot].object);
    const bool is_double_sided = places.scene.materials[static_cast<std::size_t>(object.material)].is_double_sided;
    const double mirror_sign = glm::determinant(glm::dmat3(matrix)) < 0.0 ? -1.0 : 1.0;
    std::vector<SlotTriangle> triangles;
    triangles.reserve(chunk.index_count / 3);
    for (std::uint32_t i = 0; i < chunk.index_count; i += 3) {
        SlotTriangle& triangle = triangles.emplace_back();
        triangle.facing_sign = is_double_sided ? 0.0 : mirror_sign;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = mesh.indices[chunk.first_index + i + k];
            triangle.corners_world[k] = glm::dvec3(matrix * glm::dvec4(glm::dvec3(mesh.positions[vertex]), 1.0));
        }
    }
    return triangles;
}

double slack_m(const Grid& grid)
{
    return std::max(4.0 * grid.step_m, 3e-5);
}

}  // namespace hw
