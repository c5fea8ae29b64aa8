#include "hatchway/drawing/styled_items.hpp"

namespace hw {

DrawItem item_of(const Scene& scene, ObjectId id, const StyledObject& look, bool is_over, std::uint32_t slot)
{
    const Object& object = scene.objects[id];
    DrawItem item{.object = id,
                  .mesh = &scene.meshes[object.mesh],
                  .material = &scene.materials[object.material],
                  .world_from_object = glm::mat4(scene.world_from_object(id)),
                  .bounds_world = object.bounds_world};
    item.certainty = look.certainty;
    item.slot = slot;
    if (look.over != kNone) item.presence = look.presence;
    item.is_presence_inverted = look.over != kNone && !is_over;
    return item;
}

}  // namespace hw
