#pragma once

#include <span>
#include <vector>

#include "hatchway/drawing/line_looks.hpp"
#include "hatchway/plugin_host/style_set.hpp"
#include "hatchway/stage/level_world.hpp"
#include "hatchway/world/looks.hpp"

namespace hw {

/// What objects wear by their looks, but for maps. Styles are made and prepared on their first use. Throws hw::Error
/// for a style that does not work.
std::vector<StyledObject> styled_objects(std::span<const ObjectLook> looks, StyleSet& styles);

/// How the styles of a level draw the lines of its objects in a view; nothing is drawn and no shader compiled.
std::vector<ObjectPens> level_pens(const Level& level, const Scene& scene, const PluginRegistry& registry,
                                   const View& view);

}  // namespace hw
