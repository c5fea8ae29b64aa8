#include "hatchway/io/level/inherited_styles.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

constexpr std::size_t kLongestChain = 16;  // far more than anyone reads, and bounds what a hostile file costs

using NamedStyle = std::map<std::string, StyleDesc>::value_type;

[[noreturn]] void refuse(const Level& level, const StyleDesc& style, std::string what, std::string expected)
{
    throw Error({.what = std::move(what),
                 .file = level.file.string(),
                 .pointer = style.pointer + "/like",
                 .expected = std::move(expected)});
}

const NamedStyle& base_of(const Level& level, const StyleDesc& style)
{
    const auto found = level.styles.find(style.like);
    if (found != level.styles.end()) return *found;
    std::vector<std::string> names;
    for (const auto& [name, desc] : level.styles) names.push_back(name);
    refuse(level, style, fmt::format("there is no style \"{}\" in this level", style.like),
           fmt::format("one of: {}", fmt::join(names, ", ")));
}

/// The style, what it is like, what that is like, to the one that names a plugin.
std::vector<const NamedStyle*> chain_from(const Level& level, const NamedStyle& style)
{
    std::vector<const NamedStyle*> chain{&style};
    while (!chain.back()->second.like.empty()) {
        const StyleDesc& last = chain.back()->second;
        const NamedStyle& base = base_of(level, last);
        if (std::ranges::find(chain, &base) != chain.end())
            refuse(level, last, fmt::format("\"{}\" is like itself, by way of {} styles", base.first, chain.size()),
                   "a chain of styles that ends with a plugin");
        if (chain.size() == kLongestChain)
            refuse(level, last, fmt::format("\"{}\" has a chain of more than {} styles", style.first, kLongestChain),
                   "a shorter one");
        chain.push_back(&base);
    }
    return chain;
}

}  // namespace

void inherit_styles(Level& level)
{
    for (NamedStyle& style : level.styles) {
        const std::vector<const NamedStyle*> chain = chain_from(level, style);
        style.second.plugin = chain.back()->second.plugin;
        for (const NamedStyle* base : chain)
            style.second.params.insert(base->second.params.begin(), base->second.params.end());
    }
}

}  // namespace hw
