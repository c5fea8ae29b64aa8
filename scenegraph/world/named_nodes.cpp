#include "hatchway/world/named_nodes.hpp"

#include <fmt/format.h>

#include "hatchway/core/error.hpp"
#include "hatchway/core/glob.hpp"

namespace hw {
namespace {

/// Whether there is one.
bool mark_named(const std::string& pattern, const Scene& scene, std::uint64_t& steps_left, std::vector<char>& marks)
{
    const Glob glob(pattern);
    bool is_used = false;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const bool is_number = pattern[0] == '#' && pattern == fmt::format("#{}", i);
        if (!is_number && !glob.matches(scene.nodes[i].path, steps_left)) continue;
        marks[i] = 1;
        is_used = true;
    }
    return is_used;
}

}  // namespace

void mark_named_nodes(const Scene& scene, const NodeName& name, Budget& budget, std::vector<char>& marks)
{
    budget.spend(Cost::rule_steps, scene.nodes.size(), name.file, name.pointer);
    const std::uint64_t allowed = budget.left(Cost::rule_steps);
    std::uint64_t left = allowed;
    const bool is_used = mark_named(name.nodes, scene, left, marks);
    budget.spend(Cost::rule_steps, left == 0 ? allowed + 1 : allowed - left, name.file, name.pointer);
    if (!is_used)
        throw Error({.what = fmt::format("\"{}\" names no node", name.nodes),
                     .file = name.file,
                     .pointer = name.pointer,
                     .expected = "a path glob of nodes of the scene"});
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const int parent = scene.nodes[i].parent;
        if (parent != kNone && marks[static_cast<std::size_t>(parent)]) marks[i] = 1;
    }
}

}  // namespace hw
