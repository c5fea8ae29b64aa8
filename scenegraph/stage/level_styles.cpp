#include "hatchway/stage/level_styles.hpp"

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

std::vector<ObjectPens> level_pens(const Level& level, const Scene& scene, const PluginRegistry& registry,
                                   const View& view)
{
    NoPrograms programs;
    StyleSet styles(registry, [&](const std::filesystem::path&) -> ProgramCache& { return programs; });
    styles.set_level(level);
    const std::vector<StyledObject> objects = styled_objects(resolve_looks(level, scene, kFallbackStyle), styles);
    return object_pens(scene, styles.styles(), objects, view);
}

}  // namespace hw
