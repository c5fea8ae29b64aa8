#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "hatchway/param/param_value.hpp"
#include "hatchway/plugin_host/plugin_registry.hpp"
#include "hatchway/style/style.hpp"
#include "hatchway/world/level.hpp"

namespace hw {

/// Where a style is asked for, for messages.
struct StyleSource {
    std::string file;
    std::string pointer;
    std::filesystem::path root = {};  ///< Of the level's project: images that it names lie inside.
};

/// The style plugin of that name. Throws hw::Error that lists the plugins there are, or says why the one that was found
/// is refused.
const Plugin& require_plugin(const PluginRegistry& registry, const std::string& name, PluginKind kind,
                             const StyleSource& source);

/// A fresh instance with its parameters set, not yet prepared. Throws hw::Error for an unknown parameter, a wrong type
/// or a value out of range, and when the plugin itself throws.
std::unique_ptr<Style> make_style(const Plugin& plugin, const ParamSettings& params, const StyleSource& source);
std::unique_ptr<ImagePass> make_image_pass(const Plugin& plugin, const ParamSettings& params,
                                           const StyleSource& source);

/// Visits the parameters of a fresh instance, with their defaults: for the JSON schema and the manual. Throws hw::Error
/// when the plugin throws.
void visit_defaults(const Plugin& plugin, ParamVisitor& visitor);

/// The styles that a level may name: its own, then the plugins that none of them hides.
std::vector<std::string> style_names(const PluginRegistry& registry, const std::map<std::string, StyleDesc>& styles);

/// Throws hw::Error that lists style_names() when `name` is none of them.
void require_style_name(const PluginRegistry& registry, const std::map<std::string, StyleDesc>& styles,
                        const std::string& name, const StyleSource& source);

/// A map that a style of a level names.
struct StatedMap {
    MapKind kind = MapKind::hatch;
    std::string name;
    std::string pointer;
};

/// The maps that the styles of a level state, also those that their other parameters leave unused. Throws hw::Error for
/// a style that is wrong.
std::vector<StatedMap> maps_of_styles(const PluginRegistry& registry, const Level& level);

/// Makes every style of the level once, without a device, and looks up every style that the level names. Throws
/// hw::Error for the first that is wrong.
void check_styles(const PluginRegistry& registry, const Level& level);

}  // namespace hw
