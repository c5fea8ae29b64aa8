#pragma once

#include <map>
#include <string>
#include <vector>

#include "hatchway/world/level.hpp"

namespace hw {

/// What the rules say of one object once all have been applied.
struct ObjectLook {
    std::string style;          ///< A style of the level, or a plugin's name. Never empty.
    std::string style_pointer;  ///< Where it was said; empty: nowhere, and the fallback it is.
    std::string over;           ///< Empty: none.
    std::string over_pointer;   ///< Where it was said; empty: nowhere.
    PresenceField presence;     ///< Of `over`.
    double certainty = 1.0;
    std::string certainty_pointer;        ///< Where it was said; empty: nowhere.
    std::map<MapKind, std::string> maps;  ///< As in AssignRule.
    bool collides = true;
    bool is_visible = true;
    std::string visible_pointer;  ///< Where it was said; empty: nowhere.
};

/// Applies the model's extras, then "assign" from first to last, then the certainty table where no style was said, then
/// `fallback_style`. One look for each object. Linear in rules x nodes, within a budget. Throws hw::Error for a
/// rule that names a node by an index that does not exist, or whose glob has a class that is never closed, and where
/// the budget runs out.
std::vector<ObjectLook> resolve_looks(const Level& level, const Scene& scene, const std::string& fallback_style);

}  // namespace hw
