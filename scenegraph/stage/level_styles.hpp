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

/// A bare model defines no styles: of its nodes, those that name one that no plugin has are taken as if they named
/// none, with one warning for each name. A level has to define what its model names: there that is an error where it is
/// used.
void forget_unknown_styles(const Level& level, const PluginRegistry& registry, Scene& scene);

/// How the styles of a level draw the lines of its objects in a view; nothing is drawn and no shader compiled. Throws
/// hw::Error for a style that does not work, of Fault::ours for one that throws.
std::vector<ObjectPens> level_pens(const Level& level, const Scene& scene, const PluginRegistry& registry,
                                   const View& view);

}  // namespace hw
