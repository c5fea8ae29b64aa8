#include "hatchway/world/open_backs.hpp"

#include <algorithm>
#include <cstdint>
#include <glm/matrix.hpp>
#include <optional>

#include "hatchway/geometry/topology/shell.hpp"

namespace hw {
namespace {

constexpr std::uint64_t kMostLookedAt = 20'000'000;  // triangles around places; past that what is closed is a solid

/// Where something shines or somebody looks.
struct Inmate {
    glm::dvec3 place_world;
    std::optional<ObjectId> object;  ///< That shines.
};

std::vector<Inmate> inmates_of(const Scene& scene, std::span<const Light> lights,
                               std::span<const glm::dvec3> eyes_world)
{
    std::vector<Inmate> inmates;
    for (const glm::dvec3& eye : eyes_world) inmates.push_back({eye, std::nullopt});
    for (const Light& light : lights)
        if (light.type != LightType::sun) inmates.push_back({light.position_world, std::nullopt});
    for (ObjectId id = 0; id < scene.objects.size(); ++id)
        if (scene.materials[scene.objects[id].material].emissive != glm::vec3(0.0f))
            inmates.push_back({scene.objects[id].bounds_world.centre(), id});
    return inmates;
}

bool is_room(const Scene& scene, ObjectId id, std::span<const Inmate> inmates, std::uint64_t& left)
{
    const Object& object = scene.objects[id];
    const std::uint64_t triangles = scene.meshes[object.mesh].triangle_count();
    const auto is_inside = [&](const Inmate& inmate) {
        const Box here{inmate.place_world, inmate.place_world};
        if (inmate.object == id || !object.bounds_world.overlaps(here) || left < triangles) return false;
        left -= triangles;
        const glm::dmat4 object_from_world = glm::inverse(scene.world_from_object(id));
        return is_within_shell(scene.meshes[object.mesh], object_from_world * glm::dvec4(inmate.place_world, 1.0));
    };
    return std::any_of(inmates.begin(), inmates.end(), is_inside);
}

}  // namespace

std::vector<bool> find_open_backs(const Scene& scene, std::span<const Light> lights,
                                  std::span<const glm::dvec3> eyes_world)
{
    const std::vector<Inmate> inmates = inmates_of(scene, lights, eyes_world);
    std::uint64_t left = kMostLookedAt;
    std::vector<std::optional<bool>> is_shell_of_mesh(scene.meshes.size());
    std::vector<bool> open;
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const Object& object = scene.objects[id];
        std::optional<bool>& known = is_shell_of_mesh[object.mesh];
        const bool is_double_sided = scene.materials[object.material].is_double_sided;
        if (is_double_sided && !known) known = is_shell(scene.meshes[object.mesh]);
        open.push_back(is_double_sided && (!*known || is_room(scene, id, inmates, left)));
    }
    return open;
}

}  // namespace hw
