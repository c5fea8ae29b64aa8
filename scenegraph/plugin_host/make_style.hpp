#pragma once

#include <memory>
#include <string>

#include "param/param_value.hpp"
#include "plugin_host/plugin_registry.hpp"
#include "style/style.hpp"
#include "world/level.hpp"

namespace hw {

/// Where a style is asked for, for messages.
struct StyleSource {
    std::string file;
    std::string pointer;
};

/// The style plugin of that name. Throws hw::Error that lists the plugins there are, or says why the one that was found
/// is refused.
const Plugin& require_plugin(const PluginRegistry& registry, const std::string& name, PluginKind kind,
                             const StyleSource& source);

/// A fresh instance with its parameters set, not yet prepared. Throws hw::Error for an unknown parameter, a wrong type or
/// a value out of range, and when the plugin itself throws.
std::unique_ptr<Style> make_style(const Plugin& plugin, const ParamSettings& params, const StyleSource& source);
std::unique_ptr<ImagePass> make_image_pass(const Plugin& plugin, const ParamSettings& params,
                                           const StyleSource& source);

/// Visits the parameters of a fresh instance, with their defaults: for the JSON schema and the manual. Throws hw::Error
/// when the plugin throws.
void visit_defaults(const Plugin& plugin, ParamVisitor& visitor);

/// Makes every style of the level once, without a device. Throws hw::Error for the first that is wrong.
void check_styles(const PluginRegistry& registry, const Level& level);

}  // namespace hw
