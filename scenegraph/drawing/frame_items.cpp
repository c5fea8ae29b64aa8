#include "hatchway/drawing/frame_items.hpp"

#include <algorithm>
#include <atomic>

namespace hw {
namespace {

std::uint64_t next_frame()
{
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

MaterialFacts facts_of(const Material& material)
{
    return {.base_colour = material.base_colour,
            .emissive = material.emissive,
            .metallic = material.metallic,
            .roughness = material.roughness,
            .has_base_colour_map = material.base_colour_texture.texture != kNone,
            .is_masked = material.alpha_mode == AlphaMode::mask,
            .is_blended = material.alpha_mode == AlphaMode::blend,
            .is_double_sided = material.is_double_sided,
            .is_unlit = material.is_unlit};
}

ItemFacts item_facts(const Scene& scene, ObjectId id, float certainty)
{
    const Object& object = scene.objects[id];
    const MeshData& mesh = scene.meshes[object.mesh];
    return {.object = id,
            .mesh = {.vertices = static_cast<std::uint32_t>(mesh.positions.size()),
                     .triangles = static_cast<std::uint32_t>(mesh.triangle_count()),
                     .has_uv = !mesh.uv0.empty(),
                     .has_colours = !mesh.colours.empty()},
            .material = facts_of(scene.materials[object.material]),
            .world_from_object = glm::mat4(scene.world_from_object(id)),
            .bounds_world = object.bounds_world,
            .certainty = certainty};
}

}  // namespace

FrameItems::FrameItems() : frame_(next_frame()) {}

DrawItem FrameItems::make(const ItemFacts& facts, const ItemPlace& place)
{
    DrawItem item;
    item.facts_ = facts;
    item.presence_ = place.presence;
    item.is_presence_inverted_ = place.is_presence_inverted;
    item.slot_ = place.slot;
    item.frame_ = frame_;
    slots_ = std::max(slots_, place.slot + 1);
    return item;
}

DrawItem FrameItems::make(const Scene& scene, ObjectId id, const StyledObject& look, bool is_over, std::uint32_t slot)
{
    ItemPlace place{.slot = slot};
    if (look.over != kNone) {
        place.presence = look.presence;
        place.is_presence_inverted = !is_over;
    }
    return make(item_facts(scene, id, look.certainty), place);
}

}  // namespace hw
