#include "hatchway/world/hidden_objects.hpp"

#include <algorithm>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

std::vector<ObjectId> hidden_by(const std::vector<ObjectLook>& looks)
{
    std::vector<ObjectId> ids;
    for (ObjectId id = 0; id < looks.size(); ++id)
        if (!looks[id].is_visible) ids.push_back(id);
    return ids;
}

void show_all(Scene& scene)
{
    if (scene.hidden.empty()) return;
    for (const auto& [id, object] : scene.hidden) scene.objects[id] = object;
    scene.hidden.clear();
    scene.meshes.pop_back();
}

void hide(Scene& scene, const std::vector<ObjectId>& objects)
{
    if (objects.empty()) return;
    const int empty_mesh = static_cast<int>(scene.meshes.size());
    scene.meshes.emplace_back();
    for (const ObjectId id : objects) {
        scene.hidden[id] = scene.objects[id];
        scene.objects[id].mesh = empty_mesh;
        scene.objects[id].bounds_world = {};
    }
}

}  // namespace

bool would_change(const Scene& scene, const std::vector<ObjectLook>& looks)
{
    return hidden_by(looks) != hidden_objects(scene);
}

bool hide_objects(Scene& scene, const std::vector<ObjectLook>& looks)
{
    HW_ASSERT(looks.empty() || looks.size() == scene.objects.size());
    const std::vector<ObjectId> wanted = hidden_by(looks);
    if (wanted == hidden_objects(scene)) return false;
    show_all(scene);
    hide(scene, wanted);
    scene.bounds_world = {};
    for (const Object& object : scene.objects) scene.bounds_world.add(object.bounds_world);
    return true;
}

std::vector<ObjectId> hidden_objects(const Scene& scene)
{
    std::vector<ObjectId> ids;
    for (const auto& [id, object] : scene.hidden) ids.push_back(id);
    return ids;
}

}  // namespace hw
