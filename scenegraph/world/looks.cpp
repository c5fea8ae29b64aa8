// Rules are many and objects are many: for each pair only a rule's number is written down, by key, and what the
// deciding rules say is read once, at the end.
#include "hatchway/world/looks.hpp"

#include <charconv>

#include "hatchway/core/budget.hpp"
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

constexpr std::size_t kMapSteps = 16;  // a map's name is looked up, what else a rule says is not

/// The rules that decide an object's look, by what they state; kNone where none does.
struct Deciders {
    int style = kNone;
    int over = kNone;
    int presence = kNone;
    int certainty = kNone;
    int collides = kNone;
    int visible = kNone;
    std::map<MapKind, int> maps;

    void note(const AssignRule& rule, int number)
    {
        if (rule.style) style = number;
        if (rule.over) over = number;
        if (rule.presence) presence = number;
        if (rule.certainty) certainty = number;
        if (rule.collides) collides = number;
        if (rule.visible) visible = number;
        for (const auto& [kind, path] : rule.maps) maps[kind] = number;
    }
};

/// Follows the rules over a scene, within a budget of steps.
class RuleReader {
 public:
    RuleReader(const Level& level, const Scene& scene) : level_(level), scene_(scene) {}

    std::vector<Deciders> deciders()
    {
        std::vector<Deciders> deciders(scene_.objects.size());
        for (std::size_t i = 0; i < level_.assign.size(); ++i) {
            const AssignRule& rule = level_.assign[i];
            require_sound_glob(rule.nodes, "nodes", rule, level_);
            require_sound_glob(rule.materials, "materials", rule, level_);
            spend(scene_.nodes.size() + scene_.objects.size() * (1 + kMapSteps * rule.maps.size()), rule);
            const std::vector<char> is_node = reached_nodes(rule);
            const std::vector<char> is_material = reached_materials(rule);
            for (std::size_t k = 0; k < deciders.size(); ++k)
                if (is_node[scene_.objects[k].node] && is_material[scene_.objects[k].material])
                    deciders[k].note(rule, static_cast<int>(i));
        }
        return deciders;
    }

 private:
    void spend(std::uint64_t steps, const AssignRule& rule)
    {
        budget_.spend(Cost::rule_steps, steps, level_.file.string(), rule.pointer);
    }
    bool matches(const Glob& glob, const std::string& text, const AssignRule& rule)
    {
        const std::uint64_t allowed = budget_.left(Cost::rule_steps);
        std::uint64_t left = allowed;
        const bool result = glob.matches(text, left);
        spend(left == 0 ? allowed + 1 : allowed - left, rule);
        return result;
    }
    /// For every node, whether the rule names it or one of its parents.
    std::vector<char> reached_nodes(const AssignRule& rule)
    {
        std::vector<char> reached(scene_.nodes.size(), rule.nodes.empty() ? 1 : 0);
        if (rule.nodes.empty()) return reached;
        const int index = node_index_of(rule, level_, scene_.nodes.size());
        const Glob glob(rule.nodes);
        for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
            const Node& node = scene_.nodes[i];
            const bool is_inherited = node.parent != kNone && reached[node.parent];
            reached[i] =
                is_inherited || (index == kNone ? matches(glob, node.path, rule) : index == static_cast<int>(i));
        }
        return reached;
    }
    std::vector<char> reached_materials(const AssignRule& rule)
    {
        std::vector<char> reached(scene_.materials.size(), rule.materials.empty() ? 1 : 0);
        if (rule.materials.empty()) return reached;
        const Glob glob(rule.materials);
        for (std::size_t i = 0; i < reached.size(); ++i) reached[i] = matches(glob, scene_.materials[i].name, rule);
        return reached;
    }

    const Level& level_;
    const Scene& scene_;
    Budget budget_;
};

void apply(const Deciders& deciders, const std::vector<AssignRule>& rules, ObjectLook& look)
{
    if (deciders.style != kNone) {
        look.style = *rules[deciders.style].style;
        look.style_pointer = place_in(rules[deciders.style], "style");
    }
    // Who states a style takes back what was drawn over the one before.
    if (deciders.over != kNone && deciders.over >= deciders.style) {
        look.over = *rules[deciders.over].over;
        look.over_pointer = place_in(rules[deciders.over], "over");
    }
    if (deciders.presence != kNone) look.presence = *rules[deciders.presence].presence;
    if (deciders.certainty != kNone) {
        look.certainty = *rules[deciders.certainty].certainty;
        look.certainty_pointer = place_in(rules[deciders.certainty], "certainty");
    }
    if (deciders.visible != kNone) {
        look.is_visible = *rules[deciders.visible].visible;
        look.visible_pointer = place_in(rules[deciders.visible], "visible");
    }
    if (deciders.collides != kNone) look.collides = *rules[deciders.collides].collides;
    for (const auto& [kind, rule] : deciders.maps) look.maps[kind] = rules[rule].maps.at(kind);
}

void apply_extras(const Level& level, const Scene& scene, std::vector<ObjectLook>& looks)
{
    // Messages begin with the level file, which may be the bare model itself.
    const std::string file = level.file == level.scene_file ? "" : scene.file + ": ";
    // By the node's path: its number is not the file's, and the file may say it in one of several ways.
    constexpr std::size_t kShown = 80;
    const auto place = [&](int node, const char* key) {
        return file + key + " in the extras of " + scene.nodes[node].path.substr(0, kShown);
    };
    // For each node the one that says it: itself, or its nearest parent that does.
    std::vector<int> style(scene.nodes.size(), kNone);
    std::vector<int> certainty(scene.nodes.size(), kNone);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        style[i] = node.style ? static_cast<int>(i) : node.parent == kNone ? kNone : style[node.parent];
        certainty[i] = node.certainty ? static_cast<int>(i) : node.parent == kNone ? kNone : certainty[node.parent];
    }
    for (std::size_t i = 0; i < looks.size(); ++i) {
        const int node = scene.objects[i].node;
        if (style[node] != kNone) {
            looks[i].style = *scene.nodes[style[node]].style;
            looks[i].style_pointer = place(style[node], "style");
        }
        if (certainty[node] != kNone) {
            looks[i].certainty = *scene.nodes[certainty[node]].certainty;
            looks[i].certainty_pointer = place(certainty[node], "certainty");
        }
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
    const std::vector<Deciders> deciders = RuleReader(level, scene).deciders();
    for (std::size_t i = 0; i < looks.size(); ++i) apply(deciders[i], level.assign, looks[i]);
    for (ObjectLook& look : looks) {
        if (look.style.empty()) apply_certainty_table(level, look);
        if (look.style.empty()) look.style = fallback_style;
    }
    return looks;
}

}  // namespace hw
