#include "plugin_host/make_style.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "param/param_reader.hpp"
#include "plugin_host/plugin_call.hpp"

namespace hw {
namespace {

/// Sets the parameters of a fresh instance of either kind.
template <typename Instance>
std::unique_ptr<Instance> with_params(const Plugin& plugin, Instance* (*make)(), const ParamSettings& params,
                                      const StyleSource& source)
{
    HW_ASSERT(make);
    return call_plugin(plugin.name, "making an instance", source.file, source.pointer, [&] {
        std::unique_ptr<Instance> instance(make());
        if (!instance) throw std::runtime_error("it made none");
        ParamReader reader(params, source.file);
        instance->visit_params(reader);
        reader.refuse_unknown();
        return instance;
    });
}

}  // namespace

const Plugin& require_plugin(const PluginRegistry& registry, const std::string& name, PluginKind kind,
                             const StyleSource& source)
{
    if (const Plugin* plugin = registry.find(name, kind)) return *plugin;
    const std::string kind_name = kind == PluginKind::style ? "style" : "image pass";
    const auto refused = std::find_if(registry.refused().begin(), registry.refused().end(),
                                      [&](const RefusedPlugin& candidate) { return candidate.name == name; });
    if (refused != registry.refused().end())
        throw Error({.what = fmt::format("the plugin \"{}\" ({}) cannot be used: {}", name, refused->library.string(),
                                         refused->why),
                     .file = source.file,
                     .pointer = source.pointer});
    throw Error({.what = fmt::format("there is no {} plugin \"{}\"", kind_name, name),
                 .file = source.file,
                 .pointer = source.pointer,
                 .expected = fmt::format("one of: {}", fmt::join(registry.names(kind), ", "))});
}

std::unique_ptr<Style> make_style(const Plugin& plugin, const ParamSettings& params, const StyleSource& source)
{
    return with_params<Style>(plugin, plugin.entry->make_style, params, source);
}

std::unique_ptr<ImagePass> make_image_pass(const Plugin& plugin, const ParamSettings& params,
                                           const StyleSource& source)
{
    return with_params<ImagePass>(plugin, plugin.entry->make_image_pass, params, source);
}

void visit_defaults(const Plugin& plugin, ParamVisitor& visitor)
{
    const StyleSource source{plugin.library.string(), ""};
    if (plugin.kind == PluginKind::style) {
        const auto style = make_style(plugin, {}, source);
        call_plugin(plugin.name, "visit_params", source.file, "", [&] { style->visit_params(visitor); });
    } else {
        const auto pass = make_image_pass(plugin, {}, source);
        call_plugin(plugin.name, "visit_params", source.file, "", [&] { pass->visit_params(visitor); });
    }
}

void check_styles(const PluginRegistry& registry, const Level& level)
{
    for (const auto& [name, desc] : level.styles) {
        const StyleSource source{level.file.string(), desc.pointer};
        const Plugin& plugin = require_plugin(registry, desc.plugin, PluginKind::style,
                                              {source.file, desc.pointer + "/plugin"});
        make_style(plugin, desc.params, source);
    }
}

}  // namespace hw
