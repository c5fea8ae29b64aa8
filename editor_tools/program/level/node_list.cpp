#include "program/level/node_list.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hatchway/stage/level_world.hpp"
#include "hatchway/world/looks.hpp"

namespace hw {
namespace {

std::string material_name(const Scene& scene, const Object& object)
{
    const std::string& name = scene.materials[object.material].name;
    return name.empty() ? "(unnamed)" : name;
}

std::string look_text(const ObjectLook& look)
{
    return fmt::format("{}{}, certainty {:.3g}{}", look.style, look.over.empty() ? "" : " under " + look.over,
                       look.certainty, look.is_visible ? "" : ", hidden");
}

void add_once(std::vector<std::string>& texts, std::string text)
{
    if (std::ranges::find(texts, text) == texts.end()) texts.push_back(std::move(text));
}

}  // namespace

std::vector<std::string> node_lines(const Level& level, const Scene& scene)
{
    const std::vector<ObjectLook> looks = resolve_looks(level, scene, kFallbackStyle);
    std::vector<std::vector<std::string>> materials(scene.nodes.size());
    std::vector<std::vector<std::string>> drawn(scene.nodes.size());
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const Object& object = scene.objects[id];
        materials[object.node].push_back(material_name(scene, object));
        add_once(drawn[object.node], look_text(looks[id]));
    }
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i)
        if (!materials[i].empty())
            lines.push_back(fmt::format("node        #{:<5} {:<40} {:<16} {}", i, scene.nodes[i].path,
                                        fmt::join(materials[i], ", "), fmt::join(drawn[i], "; ")));
    return lines;
}

JsonValue nodes_json(const Level& level, const Scene& scene)
{
    const std::vector<ObjectLook> looks = resolve_looks(level, scene, kFallbackStyle);
    JsonValue nodes = JsonValue::array();
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const Object& object = scene.objects[id];
        const ObjectLook& look = looks[id];
        JsonValue node = JsonValue::object();
        node.set("node", object.node).set("path", scene.nodes[object.node].path);
        node.set("material", scene.materials[object.material].name);
        node.set("style", look.style).set("style_rule", look.style_pointer).set("over", look.over);
        node.set("over_rule", look.over_pointer);
        node.set("certainty", look.certainty).set("certainty_rule", look.certainty_pointer);
        node.set("is_visible", look.is_visible).set("visible_rule", look.visible_pointer);
        nodes.push(std::move(node));
    }
    return nodes;
}

std::string hidden_text(const Scene& scene)
{
    return scene.hidden.empty() ? "" : fmt::format(" ({} hidden)", scene.hidden.size());
}

}  // namespace hw
