#include "hatchway/stage/level_styles.hpp"

#include <fmt/format.h>

#include <map>

#include "hatchway/core/error.hpp"
#include "hatchway/plugin_host/no_programs.hpp"

namespace hw {
namespace {

constexpr std::size_t kMostUnknown = 8;  // styles that are told: a stranger's model may name any number

}  // namespace

std::vector<StyledObject> styled_objects(std::span<const ObjectLook> looks, StyleSet& styles)
{
    std::vector<StyledObject> objects;
    objects.reserve(looks.size());
    for (const ObjectLook& look : looks) {
        StyledObject& object = objects.emplace_back();
        object.style = styles.use(look.style, look.style_pointer);
        if (!look.over.empty()) object.over = styles.use(look.over, look.style_pointer);
        object.presence = look.presence;
        object.certainty = static_cast<float>(look.certainty);
    }
    return objects;
}

void forget_unknown_styles(const Level& level, const PluginRegistry& registry, Scene& scene)
{
    if (level.file != level.scene_file) return;
    std::map<std::string, std::size_t> unknown;
    for (Node& node : scene.nodes) {
        if (!node.style || registry.find(*node.style, PluginKind::style)) continue;
        ++unknown[*node.style];
        node.style.reset();
    }
    std::size_t told = 0;
    for (const auto& [name, count] : unknown) {
        if (++told > kMostUnknown) break;
        const std::string who = count == 1 ? "a node names" : fmt::format("{} nodes name", count);
        const std::string what =
            who + " the style \"" + name + "\", which there is not: drawn as if that were not said";
        scene.doubts.emplace_back(
            Error({.what = what,
                   .file = scene.file,
                   .expected = "a plugin, or a level that defines it; plugins are " +
                               fmt::format("{}", fmt::join(registry.names(PluginKind::style), ", "))})
                .what());
    }
    if (unknown.size() > kMostUnknown)
        scene.doubts.push_back(fmt::format("{}: nodes name {} more styles which there are not", scene.file,
                                           unknown.size() - kMostUnknown));
}

std::vector<ObjectPens> level_pens(const Level& level, const Scene& scene, const PluginRegistry& registry,
                                   const View& view)
{
    NoPrograms programs;
    StyleSet styles(registry, [&](const std::filesystem::path&) -> ProgramCache& { return programs; });
    styles.set_level(level);
    const std::vector<StyledObject> objects = styled_objects(resolve_looks(level, scene, kFallbackStyle), styles);
    styles.set_object_namer([&](std::uint32_t object) { return scene.nodes[scene.objects[object].node].path; });
    std::vector<ObjectPens> pens = object_pens(scene, styles.styles(), objects, view);
    const std::vector<std::string> failures = styles.failures();
    if (!failures.empty()) throw Error({.what = failures.front(), .file = level.file.string(), .fault = Fault::ours});
    return pens;
}

}  // namespace hw
