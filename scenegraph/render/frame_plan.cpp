#include "hatchway/render/frame_plan.hpp"

namespace hw {
namespace {

DrawItem make_item(const SceneInput& input, const VisibleObject& object, std::uint32_t slot)
{
    const Object& facts = input.scene->objects[object.object];
    const StyledObject& look = input.objects[object.object];
    DrawItem item;
    item.object = object.object;
    item.mesh = &input.scene->meshes[facts.mesh];
    item.material = &input.scene->materials[facts.material];
    item.world_from_object = glm::mat4(input.scene->world_from_object(object.object));
    item.bounds_world = facts.bounds_world;
    item.certainty = look.certainty;
    item.slot = slot;
    return item;
}

void add_blended(FramePlan& plan, int style, const DrawItem& item)
{
    if (plan.blended_runs.empty() || plan.blended_runs.back().style != style) plan.blended_runs.push_back({style, {}});
    plan.blended_runs.back().items.push_back(item);
    plan.styles[style].blended.push_back(item);
}

}  // namespace

FramePlan plan_frame(const SceneInput& input, const VisibleSet& visible)
{
    FramePlan plan;
    plan.styles.resize(input.styles.size());
    const auto is_blended = [&](const DrawItem& item) { return item.material->alpha_mode == AlphaMode::blend; };
    const auto count = static_cast<std::uint32_t>(visible.objects.size());
    for (std::uint32_t slot = 0; slot < count; ++slot) {
        const StyledObject& look = input.objects[visible.objects[slot].object];
        DrawItem item = make_item(input, visible.objects[slot], slot);
        if (look.style == kNone || is_blended(item)) continue;
        const bool has_over = look.over != kNone;
        if (has_over) item.presence = look.presence;
        item.is_presence_inverted = has_over;
        plan.styles[look.style].base.push_back(item);
        item.is_presence_inverted = false;
        if (has_over) plan.styles[look.over].over.push_back(item);
    }
    for (std::uint32_t slot = count; slot-- > 0;) {
        const StyledObject& look = input.objects[visible.objects[slot].object];
        DrawItem item = make_item(input, visible.objects[slot], slot);
        if (look.style == kNone || !is_blended(item)) continue;
        const bool has_over = look.over != kNone;
        if (has_over) item.presence = look.presence;
        item.is_presence_inverted = has_over;
        add_blended(plan, look.style, item);
        item.is_presence_inverted = false;
        if (has_over) add_blended(plan, look.over, item);
    }
    return plan;
}

}  // namespace hw
