#include "hatchway/world/open_backs.hpp"

#include <algorithm>
#include <glm/matrix.hpp>
#include <optional>

#include "hatchway/geometry/topology/shell.hpp"

namespace hw {
namespace {

struct Lamp {
    glm::dvec3 place_world;
    std::optional<ObjectId> object;  ///< That shines.
};

std::vector<Lamp> lamps_of(const Scene& scene, std::span<const Light> lights)
{
    std::vector<Lamp> lamps;
    for (const Light& light : lights)
        if (light.type != LightType::sun) lamps.push_back({light.position_world, std::nullopt});
    for (ObjectId id = 0; id < scene.objects.size(); ++id)
        if (scene.materials[scene.objects[id].material].emissive != glm::vec3(0.0f))
            lamps.push_back({scene.objects[id].bounds_world.centre(), id});
    return lamps;
}

bool is_lit_inside(const Scene& scene, ObjectId id, std::span<const Lamp> lamps)
{
    const Object& object = scene.objects[id];
    const auto is_inside = [&](const Lamp& lamp) {
        const Box here{lamp.place_world, lamp.place_world};
        if (lamp.object == id || !object.bounds_world.overlaps(here)) return false;
        const glm::dmat4 object_from_world = glm::inverse(scene.world_from_object(id));
        return is_within_shell(scene.meshes[object.mesh], object_from_world * glm::dvec4(lamp.place_world, 1.0));
    };
    return std::any_of(lamps.begin(), lamps.end(), is_inside);
}

}  // namespace

std::vector<bool> find_open_backs(const Scene& scene, std::span<const Light> lights)
{
    const std::vector<Lamp> lamps = lamps_of(scene, lights);
    std::vector<std::optional<bool>> is_shell_of_mesh(scene.meshes.size());
    std::vector<bool> open;
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const Object& object = scene.objects[id];
        std::optional<bool>& known = is_shell_of_mesh[object.mesh];
        const bool is_double_sided = scene.materials[object.material].is_double_sided;
        if (is_double_sided && !known) known = is_shell(scene.meshes[object.mesh]);
        open.push_back(is_double_sided && (!*known || is_lit_inside(scene, id, lamps)));
    }
    return open;
}

}  // namespace hw
