#include "hatchway/render/frame_plan.hpp"

#include <algorithm>

namespace hw {
namespace {

bool is_blended(const Scene& scene, ObjectId id)
{
    return scene.materials[scene.objects[id].material].alpha_mode == AlphaMode::blend;
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
    const Scene& scene = *input.scene;
    const auto count = static_cast<std::uint32_t>(visible.objects.size());
    for (std::uint32_t slot = 0; slot < count; ++slot) {
        const ObjectId id = visible.objects[slot].object;
        const StyledObject& look = input.objects[id];
        if (look.style == kNone || is_blended(scene, id)) continue;
        plan.styles[look.style].base.push_back(plan.items.make(scene, id, look, false, slot));
        if (look.over != kNone) plan.styles[look.over].over.push_back(plan.items.make(scene, id, look, true, slot));
    }
    for (std::uint32_t slot = count; slot-- > 0;) {
        const ObjectId id = visible.objects[slot].object;
        const StyledObject& look = input.objects[id];
        if (look.style == kNone || !is_blended(scene, id)) continue;
        add_blended(plan, look.style, plan.items.make(scene, id, look, false, slot));
        if (look.over != kNone) add_blended(plan, look.over, plan.items.make(scene, id, look, true, slot));
    }
    return plan;
}

const WholeItems& whole_items(FramePlan& plan, const SceneInput& input, const VisibleSet& visible)
{
    if (plan.whole) return *plan.whole;
    WholeItems& whole = plan.whole.emplace();
    for (std::uint32_t slot = 0; slot < visible.objects.size(); ++slot) {
        const ObjectId id = visible.objects[slot].object;
        const StyledObject& look = input.objects[id];
        if (look.style == kNone) continue;
        std::vector<DrawItem>& items = is_blended(*input.scene, id) ? whole.blended : whole.opaque;
        items.push_back(plan.items.make(*input.scene, id, {.certainty = look.certainty}, false, slot));
    }
    std::reverse(whole.blended.begin(), whole.blended.end());
    return whole;
}

}  // namespace hw
