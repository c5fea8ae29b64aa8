#include "hatchway/walk/style_edits.hpp"

#include <algorithm>
#include <deque>
#include <numeric>

#include "hatchway/core/error.hpp"
#include "hatchway/core/glob.hpp"

namespace hw {
namespace {

std::string escaped(const std::string& name)
{
    std::string glob;
    for (const char c : name) {
        if (c == '*' || c == '?' || c == '[')
            glob += std::string("[") + c + ']';
        else
            glob += c;
    }
    return glob;
}

/// For every node, whether it is `top` or below it. Parents stand before their children.
std::vector<char> nodes_below(const Scene& scene, int top)
{
    std::vector<char> is_below(scene.nodes.size(), 0);
    for (std::size_t i = top; i < scene.nodes.size(); ++i) {
        const int parent = scene.nodes[i].parent;
        is_below[i] = static_cast<int>(i) == top || (parent >= top && is_below[parent]);
    }
    return is_below;
}

const std::string& material_name(const Scene& scene, ObjectId object)
{
    return scene.materials[scene.objects[object].material].name;
}

bool is_reached(const Scene& scene, const AssignRule& rule, const std::vector<char>& is_below, ObjectId object)
{
    return is_below[scene.objects[object].node] &&
           (rule.materials.empty() || glob_matches(rule.materials, material_name(scene, object)));
}

AssignRule rule_with(const StyleChoice& choice)
{
    AssignRule rule;
    rule.visible = choice.visible;
    if (choice.style.empty()) return rule;
    rule.style = choice.style;
    if (!choice.over.empty()) {
        rule.over = choice.over;
        rule.presence = choice.presence;
    }
    return rule;
}

StyleChoice style_alone(StyleChoice choice)
{
    choice.visible.reset();
    return choice;
}

StyleChoice visibility_alone(const StyleChoice& choice)
{
    return {.style = "", .visible = choice.visible};
}

/// `choice`, and what it says nothing of from `base`.
StyleChoice completed(StyleChoice choice, const StyleChoice& base)
{
    const std::optional<bool> visible = choice.visible ? choice.visible : base.visible;
    if (choice.style.empty()) choice = base;
    choice.visible = visible;
    return choice;
}

/// The shortest rule that gives `object` its choice: for its node and what is below where all of that wants the same,
/// else for its material on that node.
AssignRule rule_for(const Scene& scene, ObjectId object, const std::vector<StyleChoice>& wanted,
                    const std::vector<char>& is_below)
{
    AssignRule rule = rule_with(wanted[object]);
    rule.nodes = node_selector(scene, scene.objects[object].node);
    const auto disagrees = [&](ObjectId other) {
        return is_below[scene.objects[other].node] && !(wanted[other] == wanted[object]);
    };
    for (ObjectId other = 0; other < scene.objects.size(); ++other)
        if (disagrees(other) && material_name(scene, other) != material_name(scene, object))
            rule.materials = escaped(material_name(scene, object));
    return rule;
}

std::vector<StyleChoice> choices_of(const std::vector<ObjectLook>& looks)
{
    std::vector<StyleChoice> choices;
    for (const ObjectLook& look : looks) choices.push_back(choice_of(look));
    return choices;
}

/// Parents before children; on one node the unnamed materials first, whose rules reach all of the node.
std::vector<ObjectId> order_of_rules(const Scene& scene)
{
    std::vector<ObjectId> order(scene.objects.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](ObjectId a, ObjectId b) {
        const auto key = [&](ObjectId id) {
            return std::pair(scene.objects[id].node, !material_name(scene, id).empty());
        };
        return key(a) < key(b);
    });
    return order;
}

/// What every object shall look like. No rule can tell equal materials on one node apart: they follow the wanted one.
std::vector<StyleChoice> goals(const Scene& scene, std::vector<StyleChoice> now,
                               const std::map<ObjectId, StyleChoice>& wanted)
{
    for (const auto& [object, choice] : wanted) {
        if (object >= now.size()) continue;
        for (ObjectId other = 0; other < now.size(); ++other)
            if (scene.objects[other].node == scene.objects[object].node &&
                material_name(scene, other) == material_name(scene, object))
                now[other] = completed(choice, now[other]);
    }
    return now;
}

/// Appends the rules that turn `now` into `goal`. In this order a rule disturbs only what the loop has not passed yet,
/// and what it disturbs is then put right.
void add_rules(const Scene& scene, std::vector<StyleChoice> now, const std::vector<StyleChoice>& goal,
               std::vector<AssignRule>& rules)
{
    for (const ObjectId object : order_of_rules(scene)) {
        if (now[object] == goal[object]) continue;
        const std::vector<char> is_below = nodes_below(scene, scene.objects[object].node);
        rules.push_back(rule_for(scene, object, goal, is_below));
        for (ObjectId other = 0; other < goal.size(); ++other)
            if (is_reached(scene, rules.back(), is_below, other)) now[other] = goal[object];
    }
}

template <typename Part>
std::vector<StyleChoice> parts_of(const std::vector<StyleChoice>& choices, Part part)
{
    std::vector<StyleChoice> parts;
    for (const StyleChoice& choice : choices) parts.push_back(part(choice));
    return parts;
}

}  // namespace

bool StyleChoice::operator==(const StyleChoice& other) const
{
    return style == other.style && over == other.over && (over.empty() || presence == other.presence) &&
           visible == other.visible;
}

void StyleEdits::push(StyleEdit edit)
{
    for (; saved_count_ > done_count_; --saved_count_) {
        const StyleEdit& lost = steps_[saved_count_ - 1];
        taken_back_[lost.object] = completed(lost.before, taken_back_[lost.object]);
    }
    steps_.resize(done_count_);
    steps_.push_back(std::move(edit));
    ++done_count_;
}

std::optional<StyleEdit> StyleEdits::undo()
{
    if (done_count_ == 0) return std::nullopt;
    while (steps_[--done_count_].is_with_last && done_count_ > 0) continue;
    return steps_[done_count_];
}

std::optional<StyleEdit> StyleEdits::redo()
{
    if (done_count_ == steps_.size()) return std::nullopt;
    const StyleEdit first = steps_[done_count_++];
    while (done_count_ < steps_.size() && steps_[done_count_].is_with_last) ++done_count_;
    return first;
}

std::map<ObjectId, StyleChoice> StyleEdits::unsaved() const
{
    std::map<ObjectId, StyleChoice> choices = taken_back_;
    const auto choose = [&](ObjectId object, const StyleChoice& choice) {
        choices[object] = completed(choice, choices[object]);
    };
    for (std::size_t i = saved_count_; i < done_count_; ++i) choose(steps_[i].object, steps_[i].after);
    for (std::size_t i = saved_count_; i > done_count_; --i) choose(steps_[i - 1].object, steps_[i - 1].before);
    return choices;
}

void StyleEdits::mark_saved()
{
    saved_count_ = done_count_;
    taken_back_.clear();
}

void StyleEdits::renumber(const std::map<ObjectId, ObjectId>& new_of_old)
{
    StyleEdits kept;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        const auto found = new_of_old.find(steps_[i].object);
        if (found == new_of_old.end()) continue;
        kept.steps_.push_back(steps_[i]);
        kept.steps_.back().object = found->second;
        kept.done_count_ += i < done_count_ ? 1 : 0;
        kept.saved_count_ += i < saved_count_ ? 1 : 0;
    }
    for (const auto& [object, choice] : taken_back_)
        if (const auto found = new_of_old.find(object); found != new_of_old.end())
            kept.taken_back_[found->second] = choice;
    *this = std::move(kept);
}

StyleChoice choice_of(const ObjectLook& look)
{
    return {look.style, look.over, look.presence, look.is_visible};
}

std::string next_style(const std::vector<std::string>& names, const std::string& current, int step)
{
    HW_ASSERT(!names.empty());
    const auto found = std::find(names.begin(), names.end(), current);
    if (found == names.end()) return names.front();
    const auto count = static_cast<std::ptrdiff_t>(names.size());
    return names[((found - names.begin() + step) % count + count) % count];
}

std::vector<AssignRule> rules_for(const Level& level, const Scene& scene, const std::string& fallback_style,
                                  const std::map<ObjectId, StyleChoice>& wanted)
{
    const std::vector<StyleChoice> now = choices_of(resolve_looks(level, scene, fallback_style));
    const std::vector<StyleChoice> goal = goals(scene, now, wanted);

    std::vector<AssignRule> rules;
    add_rules(scene, parts_of(now, style_alone), parts_of(goal, style_alone), rules);
    add_rules(scene, parts_of(now, visibility_alone), parts_of(goal, visibility_alone), rules);
    return rules;
}

std::string node_selector(const Scene& scene, int node)
{
    const std::string& path = scene.nodes[node].path;
    const auto same =
        std::count_if(scene.nodes.begin(), scene.nodes.end(), [&](const Node& other) { return other.path == path; });
    if (same > 1 || path.empty() || path[0] == '#') return '#' + std::to_string(node);
    return escaped(path);
}

std::vector<ObjectKey> object_keys(const Scene& scene)
{
    std::vector<ObjectKey> keys;
    for (ObjectId id = 0; id < scene.objects.size(); ++id)
        keys.push_back({scene.nodes[scene.objects[id].node].path, material_name(scene, id)});
    return keys;
}

std::map<ObjectId, ObjectId> matching_objects(const std::vector<ObjectKey>& before, const std::vector<ObjectKey>& after)
{
    std::map<ObjectKey, std::deque<ObjectId>> waiting;
    for (ObjectId id = 0; id < after.size(); ++id) waiting[after[id]].push_back(id);
    std::map<ObjectId, ObjectId> new_of_old;
    for (ObjectId id = 0; id < before.size(); ++id) {
        std::deque<ObjectId>& equals = waiting[before[id]];
        if (equals.empty()) continue;
        new_of_old[id] = equals.front();
        equals.pop_front();
    }
    return new_of_old;
}

std::string object_name(const Scene& scene, ObjectId object)
{
    const int node = scene.objects[object].node;
    const auto primitives = std::count_if(scene.objects.begin(), scene.objects.end(),
                                          [&](const Object& other) { return other.node == node; });
    const std::string& path = scene.nodes[node].path;
    return primitives > 1 && !material_name(scene, object).empty() ? path + " (" + material_name(scene, object) + ')'
                                                                   : path;
}

}  // namespace hw
