#include "program/level/level_doubts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hatchway/core/glob.hpp"
#include "hatchway/core/log.hpp"

namespace hw {
namespace {

bool names_something(const AssignRule& rule, const Scene& scene)
{
    const Glob nodes(rule.nodes);
    const Glob materials(rule.materials);
    const auto is_node = [&](const Node& node) { return rule.nodes[0] == '#' || nodes.matches(node.path); };
    const auto is_material = [&](const Material& material) { return materials.matches(material.name); };
    return (rule.nodes.empty() || std::any_of(scene.nodes.begin(), scene.nodes.end(), is_node)) &&
           (rule.materials.empty() || std::any_of(scene.materials.begin(), scene.materials.end(), is_material));
}

bool says_nothing(const AssignRule& rule)
{
    return !rule.style && !rule.over && !rule.presence && !rule.certainty && !rule.collides && !rule.visible &&
           rule.maps.empty();
}

/// Of the rules from number `first` on.
std::vector<std::string> doubts_from(const Level& level, const Scene& scene, std::size_t first)
{
    std::vector<std::string> found;
    for (std::size_t i = first; i < level.assign.size(); ++i) {
        const AssignRule& rule = level.assign[i];
        if (says_nothing(rule))
            found.push_back(
                fmt::format("{}: {}: the rule says nothing of what it names", level.file.string(), rule.pointer));
        if (names_something(rule, scene)) continue;
        constexpr std::size_t kShown = 80;
        const std::string names = (rule.materials.empty() ? rule.nodes : rule.materials).substr(0, kShown);
        found.push_back(
            fmt::format("{}: {}: \"{}\" names nothing in the model", level.file.string(), rule.pointer, names));
    }
    return found;
}

}  // namespace

std::vector<std::string> level_doubts(const Level& level, const Scene& scene)
{
    return doubts_from(level, scene, 0);
}

void warn_of_idle_styles(const Level& level, const Scene& scene, std::size_t style_count)
{
    for (const std::string& doubt : doubts_from(level, scene, level.assign.size() - style_count)) log_warning(doubt);
}

}  // namespace hw
