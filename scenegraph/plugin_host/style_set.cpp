#include "hatchway/plugin_host/style_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "hatchway/core/error.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/plugin_host/plugin_call.hpp"

namespace hw {
namespace {

bool same_values(const ParamSettings& a, const ParamSettings& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& left, const auto& right) {
        return left.first == right.first && left.second.value == right.second.value;
    });
}

}  // namespace

StyleSet::StyleSet(const PluginRegistry& registry, ProgramSource programs)
    : registry_(registry), programs_(std::move(programs))
{
    plain_.prepare(programs_({}));
}

void StyleSet::set_level(const Level& level)
{
    check_styles(registry_, level);
    const auto old_styles = std::exchange(level_styles_, level.styles);
    const auto old_level = std::exchange(level_, {level.file.string(), "", level.project_root});
    std::vector<Change> changes;
    try {
        changes = changes_of_level();
    } catch (...) {
        level_styles_ = old_styles;
        level_ = old_level;
        throw;
    }
    for (Change& change : changes) {
        Instance& instance = instances_[change.index];
        instance.wanted = std::move(change.wanted);
        instance.style->replace(instance.wanted.plugin, std::move(change.style));
    }
}

std::vector<StyleSet::Change> StyleSet::changes_of_level()
{
    std::vector<Change> changes;
    for (std::size_t i = 0; i < instances_.size(); ++i) {
        const Instance& instance = instances_[i];
        const bool is_gone =
            !level_styles_.contains(instance.name) && !registry_.find(instance.name, PluginKind::style);
        if (is_gone) continue;  // no object can name it any more; its place stays
        Wanted now = wanted(instance.name, "");
        if (now.plugin == instance.wanted.plugin && same_values(now.params, instance.wanted.params)) continue;
        auto style = prepared(now);
        changes.push_back({i, std::move(now), std::move(style)});
    }
    return changes;
}

StyleSet::Wanted StyleSet::wanted(const std::string& name, const std::string& pointer) const
{
    const auto named = level_styles_.find(name);
    if (named != level_styles_.end())
        return {named->second.plugin, named->second.params, {level_.file, named->second.pointer, level_.root}};
    require_style_name(registry_, level_styles_, name, {level_.file, pointer});
    return {name, {}, {level_.file, pointer}};
}

std::unique_ptr<Style> StyleSet::prepared(const Wanted& wanted)
{
    const Plugin& plugin = require_plugin(registry_, wanted.plugin, PluginKind::style, wanted.source);
    const PluginCall noted(plugin.name, "prepare");
    auto style = make_style(plugin, wanted.params, wanted.source);
    call_plugin(plugin.name, "prepare", wanted.source.file, wanted.source.pointer,
                [&] { style->prepare(programs_(plugin.shader_folder)); });
    call_plugin(plugin.name, "needs", wanted.source.file, wanted.source.pointer, [&] { style->needs(); });
    return style;
}

int StyleSet::use(const std::string& name, const std::string& pointer)
{
    for (std::size_t i = 0; i < instances_.size(); ++i)
        if (instances_[i].name == name) return static_cast<int>(i);
    Wanted now = wanted(name, pointer);
    auto style = std::make_unique<GuardedStyle>(name, Guarded{now.plugin, object_name_}, prepared(now), plain_);
    styles_.push_back({name, style.get()});
    instances_.push_back({name, std::move(now), std::move(style)});
    return static_cast<int>(instances_.size()) - 1;
}

std::vector<std::string> StyleSet::names() const
{
    return style_names(registry_, level_styles_);
}

std::vector<std::string> StyleSet::prepare_again()
{
    std::vector<std::string> messages;
    image_failures_.clear();
    for (Instance& instance : instances_) {
        try {
            instance.style->replace(instance.wanted.plugin, prepared(instance.wanted));
        } catch (const Error& error) {
            messages.push_back(fmt::format("the style \"{}\" stays as it was: {}", instance.name, error.what()));
        }
    }
    return messages;
}

std::vector<std::string> StyleSet::failures() const
{
    std::vector<std::string> messages = image_failures_;
    for (const Instance& instance : instances_)
        if (!instance.style->failure().empty()) messages.push_back(instance.style->failure());
    return messages;
}

ImagePassSource StyleSet::image_passes()
{
    return [this](const ImageKey& key) -> std::unique_ptr<ImagePass> {
        try {
            return image_pass(key);
        } catch (const Error& error) {
            log_error(fmt::format("the image \"{}\" is not made: {}", key.pass, error.what()));
            return nullptr;
        }
    };
}

std::unique_ptr<ImagePass> StyleSet::image_pass(const ImageKey& key)
{
    const StyleSource source{"", "/images/" + key.pass};
    const Plugin& plugin = require_plugin(registry_, key.pass, PluginKind::image_pass, source);
    ParamSettings params;
    for (const auto& [name, value] : key.params) params[name] = {value, source.pointer + "/" + name};
    auto pass = make_image_pass(plugin, params, source);
    call_plugin(plugin.name, "prepare", source.file, source.pointer,
                [&] { pass->prepare(programs_(plugin.shader_folder)); });
    return std::make_unique<GuardedImagePass>(Guarded{plugin.name, object_name_}, std::move(pass),
                                              [this](const std::string& failure) {
                                                  log_error(failure);
                                                  image_failures_.push_back(failure);
                                              });
}

}  // namespace hw
