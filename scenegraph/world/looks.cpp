#include "hatchway/world/looks.hpp"

#include <charconv>

#include "hatchway/core/error.hpp"
#include "hatchway/core/glob.hpp"

namespace hw {
namespace {

void require_sound_glob(const std::string& glob, const char* key, const AssignRule& rule, const Level& level)
{
    const std::string fault = glob_fault(glob);
    if (fault.empty()) return;
    throw Error({.what = '"' + glob + "\" has " + fault,
                 .file = level.file.string(),
                 .pointer = place_in(rule, key),
                 .expected = "a glob of *, **, ? and classes such as [0-9]"});
}

/// "#12" as a node index; kNone when the glob is none.
int node_index_of(const AssignRule& rule, const Level& level, std::size_t node_count)
{
    if (rule.nodes.empty() || rule.nodes[0] != '#') return kNone;
    std::size_t index = 0;
    const char* end = rule.nodes.data() + rule.nodes.size();
    const auto [stop, status] = std::from_chars(rule.nodes.data() + 1, end, index);
    if (status == std::errc() && stop == end && index < node_count) return static_cast<int>(index);
    throw Error({.what = "there is no node \"" + rule.nodes + '"',
                 .file = level.file.string(),
                 .pointer = place_in(rule, "nodes"),
                 .expected = "a path glob, or # and an index below " + std::to_string(node_count)});
}

/// For every node, whether the rule names it or one of its parents.
std::vector<char> reached_nodes(const AssignRule& rule, const Level& level, const Scene& scene)
{
    std::vector<char> reached(scene.nodes.size(), rule.nodes.empty() ? 1 : 0);
    if (rule.nodes.empty()) return reached;
    const int index = node_index_of(rule, level, scene.nodes.size());
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        const bool is_named = index == kNone ? glob_matches(rule.nodes, node.path) : index == static_cast<int>(i);
        reached[i] = is_named || (node.parent != kNone && reached[node.parent]);
    }
    return reached;
}

void apply(const AssignRule& rule, ObjectLook& look)
{
    if (rule.style) {
        look.style = *rule.style;
        look.style_pointer = place_in(rule, "style");
        look.over.clear();
    }
    if (rule.over) look.over = *rule.over;
    if (rule.presence) look.presence = *rule.presence;
    if (rule.certainty) look.certainty = *rule.certainty;
    if (rule.collides) look.collides = *rule.collides;
    for (const auto& [kind, path] : rule.maps) look.maps[kind] = path;
}

void apply_extras(const Level& level, const Scene& scene, std::vector<ObjectLook>& looks)
{
    // Messages begin with the level file, which may be the bare model itself.
    const std::string file = level.file == level.scene_file ? "" : scene.file + ": ";
    std::vector<const std::string*> style(scene.nodes.size(), nullptr);
    std::vector<const float*> certainty(scene.nodes.size(), nullptr);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        style[i] = node.style ? &*node.style : node.parent == kNone ? nullptr : style[node.parent];
        certainty[i] = node.certainty ? &*node.certainty : node.parent == kNone ? nullptr : certainty[node.parent];
    }
    for (std::size_t i = 0; i < looks.size(); ++i) {
        const int node = scene.objects[i].node;
        if (style[node]) {
            looks[i].style = *style[node];
            looks[i].style_pointer = file + "/nodes/" + std::to_string(node) + "/extras/hatchway/style";
        }
        if (certainty[node]) looks[i].certainty = *certainty[node];
    }
}

void apply_certainty_table(const Level& level, ObjectLook& look)
{
    const CertaintyStyle* best = nullptr;
    for (const CertaintyStyle& entry : level.certainty_styles)
        if (look.certainty >= entry.from && (!best || entry.from > best->from)) best = &entry;
    if (!best) return;
    look.style = best->style;
    look.style_pointer = "/certainty_styles/" + std::to_string(best - level.certainty_styles.data()) + "/style";
}

}  // namespace

std::vector<ObjectLook> resolve_looks(const Level& level, const Scene& scene, const std::string& fallback_style)
{
    std::vector<ObjectLook> looks(scene.objects.size());
    apply_extras(level, scene, looks);
    for (const AssignRule& rule : level.assign) {
        require_sound_glob(rule.nodes, "nodes", rule, level);
        require_sound_glob(rule.materials, "materials", rule, level);
        const std::vector<char> reached = reached_nodes(rule, level, scene);
        for (std::size_t i = 0; i < looks.size(); ++i) {
            const Object& object = scene.objects[i];
            const std::string& material = scene.materials[object.material].name;
            if (reached[object.node] && (rule.materials.empty() || glob_matches(rule.materials, material)))
                apply(rule, looks[i]);
        }
    }
    for (ObjectLook& look : looks) {
        if (look.style.empty()) apply_certainty_table(level, look);
        if (look.style.empty()) look.style = fallback_style;
    }
    return looks;
}

}  // namespace hw
