#include "hatchway/plugin_host/make_style.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hatchway/core/error.hpp"
#include "hatchway/param/param_reader.hpp"
#include "hatchway/plugin_host/plugin_call.hpp"

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
        ParamReader reader(params, source.file, source.root);
        instance->visit_params(reader);
        reader.refuse_unknown();
        return instance;
    });
}

// Named around an instance that goes at once, so that a crash of its destructor is noted, too.
constexpr const char* kCheck = "a check of its parameters";

/// Collects the maps that a style states.
class MapCollector final : public ParamVisitor {
 public:
    MapCollector(const StyleDesc& style, std::vector<StatedMap>& maps) : style_(style), maps_(maps) {}

    void real(const ParamInfo&, float&, float, float) override {}
    void whole(const ParamInfo&, int&, int, int) override {}
    void flag(const ParamInfo&, bool&) override {}
    void colour(const ParamInfo&, glm::vec3&) override {}
    void map(const ParamInfo& info, MapName& value, MapKind kind) override
    {
        const auto stated = style_.params.find(std::string(info.name));
        if (stated != style_.params.end() && !value.value.empty())
            maps_.push_back({kind, value.value, stated->second.pointer});
    }
    void image(const ParamInfo&, ImageFile&) override {}

 private:
    void choice_of(const ParamInfo&, int&, std::span<const std::string_view>) override {}
    const StyleDesc& style_;
    std::vector<StatedMap>& maps_;
};

/// A fresh instance of a level's style.
std::unique_ptr<Style> style_of(const PluginRegistry& registry, const Level& level, const StyleDesc& style)
{
    const std::string file = level.file.string();
    const std::string place = style.pointer + (style.like.empty() ? "/plugin" : "/like");
    const Plugin& plugin = require_plugin(registry, style.plugin, PluginKind::style, {file, place});
    return make_style(plugin, style.params, {file, style.pointer, level.project_root});
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

std::unique_ptr<ImagePass> make_image_pass(const Plugin& plugin, const ParamSettings& params, const StyleSource& source)
{
    return with_params<ImagePass>(plugin, plugin.entry->make_image_pass, params, source);
}

void visit_defaults(const Plugin& plugin, ParamVisitor& visitor)
{
    const PluginCall noted(plugin.name, kCheck);
    const StyleSource source{plugin.library.string(), ""};
    if (plugin.kind == PluginKind::style) {
        const auto style = make_style(plugin, {}, source);
        call_plugin(plugin.name, "visit_params", source.file, "", [&] { style->visit_params(visitor); });
    } else {
        const auto pass = make_image_pass(plugin, {}, source);
        call_plugin(plugin.name, "visit_params", source.file, "", [&] { pass->visit_params(visitor); });
    }
}

std::vector<std::string> style_names(const PluginRegistry& registry, const std::map<std::string, StyleDesc>& styles)
{
    std::vector<std::string> result;
    for (const auto& [name, style] : styles) result.push_back(name);
    for (const std::string& plugin : registry.names(PluginKind::style))
        if (!styles.contains(plugin)) result.push_back(plugin);
    return result;
}

void require_style_name(const PluginRegistry& registry, const std::map<std::string, StyleDesc>& styles,
                        const std::string& name, const StyleSource& source)
{
    if (styles.contains(name) || registry.find(name, PluginKind::style)) return;
    throw Error({.what = fmt::format("there is no style \"{}\"", name),
                 .file = source.file,
                 .pointer = source.pointer,
                 .expected = fmt::format("one of: {}", fmt::join(style_names(registry, styles), ", "))});
}

std::vector<StatedMap> maps_of_styles(const PluginRegistry& registry, const Level& level)
{
    std::vector<StatedMap> maps;
    for (const auto& [name, desc] : level.styles) {
        const PluginCall noted(desc.plugin, kCheck);
        const std::unique_ptr<Style> style = style_of(registry, level, desc);
        MapCollector collector(desc, maps);
        call_plugin(desc.plugin, "visit_params", level.file.string(), desc.pointer,
                    [&] { style->visit_params(collector); });
    }
    return maps;
}

void check_styles(const PluginRegistry& registry, const Level& level)
{
    for (const auto& [name, desc] : level.styles) {
        const PluginCall noted(desc.plugin, kCheck);
        style_of(registry, level, desc);
    }
    const auto require = [&](const std::string& name, const std::string& pointer) {
        require_style_name(registry, level.styles, name, {level.file.string(), pointer});
    };
    for (const AssignRule& rule : level.assign) {
        if (rule.style) require(*rule.style, place_in(rule, "style"));
        if (rule.over) require(*rule.over, place_in(rule, "over"));
    }
    for (std::size_t i = 0; i < level.certainty_styles.size(); ++i)
        require(level.certainty_styles[i].style, fmt::format("/certainty_styles/{}/style", i));
}

}  // namespace hw
