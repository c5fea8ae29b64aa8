#include "hatchway/drawing/line_looks.hpp"

#include <algorithm>

#include "hatchway/plugin_host/style_set.hpp"
#include "hatchway/stage/level_world.hpp"

namespace hw {
namespace {

/// Says yes to every shader: lines are found without a device.
class NoPrograms final : public ProgramCache {
 public:
    Program surface(std::string_view, std::string_view) override { return {1}; }
    Program full_screen(std::string_view, std::string_view) override { return {1}; }
};

/// Writes down with which look each object's lines would be drawn.
class LookRecorder final : public Pass {
 public:
    LookRecorder(const View& view, std::vector<ObjectInk>& inks) : view_(view), inks_(inks) {}

    const View& view() const override { return view_; }
    Image image(const ImageKey&) const override { return {}; }
    Image render(const TargetDesc&, Program, const Uniforms&, std::span<const DrawItem>) override { return {}; }
    Image filter(const TargetDesc&, Program, const Uniforms&) override { return {}; }
    void surfaces(Program, const Uniforms&, std::span<const DrawItem>) override {}
    void lines(const LineLook& look, std::span<const DrawItem> items) override
    {
        for (const DrawItem& item : items)
            inks_[item.object].looks.push_back({look, item.presence, item.is_presence_inverted, view_.time_s});
    }

 private:
    const View& view_;
    std::vector<ObjectInk>& inks_;
};

struct ObjectStyles {
    int style = kNone;
    int over = kNone;
};

DrawItem item_of(const Scene& scene, ObjectId id, const ObjectLook& look)
{
    const Object& object = scene.objects[id];
    DrawItem item{.object = id,
                  .mesh = &scene.meshes[object.mesh],
                  .material = &scene.materials[object.material],
                  .world_from_object = glm::mat4(scene.world_from_object(id)),
                  .bounds_world = object.bounds_world};
    item.certainty = static_cast<float>(look.certainty);
    return item;
}

void add_need(ObjectInk& ink, const Needs& needs)
{
    if (!needs.edges) return;
    ink.crease_rad = ink.is_used ? std::min(ink.crease_rad, needs.edges->crease_rad) : needs.edges->crease_rad;
    ink.is_used = true;
    ink.has_intersections = ink.has_intersections || needs.edges->intersections;
}

}  // namespace

std::vector<ObjectInk> object_inks(const Level& level, const Scene& scene, const PluginRegistry& registry,
                                   const View& view)
{
    NoPrograms programs;
    StyleSet styles(registry, [&](const std::filesystem::path&) -> ProgramCache& { return programs; });
    styles.set_level(level);
    const std::vector<ObjectLook> looks = resolve_looks(level, scene, kFallbackStyle);
    std::vector<ObjectInk> inks(scene.objects.size());
    std::vector<ObjectStyles> used(scene.objects.size());
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        used[id].style = styles.use(looks[id].style, looks[id].style_pointer);
        if (!looks[id].over.empty()) used[id].over = styles.use(looks[id].over, looks[id].style_pointer);
        inks[id].style_group = static_cast<std::uint32_t>((used[id].style + 1) * 65536 + used[id].over + 1);
    }
    LookRecorder recorder(view, inks);
    for (int style = 0; style < static_cast<int>(styles.styles().size()); ++style) {
        Style& drawing = *styles.styles()[style].style;
        std::vector<DrawItem> items;
        for (ObjectId id = 0; id < scene.objects.size(); ++id) {
            if (used[id].style != style && used[id].over != style) continue;
            add_need(inks[id], drawing.needs());
            DrawItem item = item_of(scene, id, looks[id]);
            if (used[id].over != kNone) item.presence = looks[id].presence;
            item.is_presence_inverted = used[id].over != kNone && used[id].over != style;
            items.push_back(item);
        }
        if (!items.empty() && drawing.needs().edges) drawing.lines(recorder, items);
    }
    return inks;
}

}  // namespace hw
