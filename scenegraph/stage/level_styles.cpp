#include "hatchway/stage/level_styles.hpp"

#include <fmt/format.h>

#include <map>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

class NoPrograms final : public ProgramCache {
 public:
    Program surface(std::string_view, std::string_view) override { return {1}; }
    Program full_screen(std::string_view, std::string_view) override { return {1}; }
    Program line(std::string_view, std::string_view) override { return {1}; }
    Image texture(std::string_view) override { return {}; }
};

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
    for (const auto& [name, count] : unknown)
        scene.doubts.push_back(fmt::format(
            "{}: {} node{} the style \"{}\", which no plugin is and no level defines: drawn as if nothing were said",
            scene.file, count, count == 1 ? " names" : "s name", name));
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
