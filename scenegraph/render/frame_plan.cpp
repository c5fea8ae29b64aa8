#include "hatchway/render/frame_plan.hpp"

namespace hw {
namespace {

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
    const Scene& scene = *input.scene;
    const auto is_blended = [&](ObjectId id) {
        return scene.materials[scene.objects[id].material].alpha_mode == AlphaMode::blend;
    };
    const auto count = static_cast<std::uint32_t>(visible.objects.size());
    for (std::uint32_t slot = 0; slot < count; ++slot) {
        const ObjectId id = visible.objects[slot].object;
        const StyledObject& look = input.objects[id];
        if (look.style == kNone || is_blended(id)) continue;
        plan.styles[look.style].base.push_back(plan.items.make(scene, id, look, false, slot));
        if (look.over != kNone) plan.styles[look.over].over.push_back(plan.items.make(scene, id, look, true, slot));
    }
    for (std::uint32_t slot = count; slot-- > 0;) {
        const ObjectId id = visible.objects[slot].object;
        const StyledObject& look = input.objects[id];
        if (look.style == kNone || !is_blended(id)) continue;
        add_blended(plan, look.style, plan.items.make(scene, id, look, false, slot));
        if (look.over != kNone) add_blended(plan, look.over, plan.items.make(scene, id, look, true, slot));
    }
    return plan;
}

}  // namespace hw
