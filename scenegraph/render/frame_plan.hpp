#pragma once

#include <optional>
#include <span>
#include <vector>

#include "hatchway/drawing/frame_items.hpp"
#include "hatchway/render/view/scene_input.hpp"
#include "hatchway/render/view/visible_set.hpp"

namespace hw {

/// The items of one style in one frame, near before far.
struct StyleItems {
    std::vector<DrawItem> base;     ///< Opaque and masked, the object's first style.
    std::vector<DrawItem> over;     ///< Opaque and masked, its second.
    std::vector<DrawItem> blended;  ///< glTF BLEND, either.
    bool is_empty() const { return base.empty() && over.empty() && blended.empty(); }
};

/// Items that one call of a style draws.
struct StyleRun {
    int style = kNone;
    std::vector<DrawItem> items;
};

/// Every visible object once, whatever its styles: without presence.
struct WholeItems {
    std::vector<DrawItem> opaque;   ///< And masked; near before far.
    std::vector<DrawItem> blended;  ///< Back to front.
};

/// Who draws what in a frame.
struct FramePlan {
    FrameItems items;
    std::vector<StyleItems> styles;      ///< One for each named style.
    std::vector<StyleRun> blended_runs;  ///< Back to front across styles.
    std::optional<WholeItems> whole;     ///< By whole_items().
};

/// Sorts the visible objects by style. An item's slot is its place in `visible.objects`.
FramePlan plan_frame(const SceneInput& input, const VisibleSet& visible);

/// Made when first asked for: most frames need none.
const WholeItems& whole_items(FramePlan& plan, const SceneInput& input, const VisibleSet& visible);

}  // namespace hw
