#include "hatchway/stage/map_store.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hatchway/core/budget.hpp"
#include "hatchway/core/error.hpp"
#include "hatchway/io/images/map_file.hpp"

namespace hw {
namespace {

std::uint64_t texel_count(const MapLevels& map)
{
    std::uint64_t count = 0;
    for (const Pixels& level : map.levels) count += static_cast<std::uint64_t>(level.width) * level.height;
    return count;
}

}  // namespace

int MapStore::use(const Level& level, MapKind kind, const std::string& name, const std::string& pointer)
{
    const std::filesystem::path folder = find_map(level, kind, name, pointer);
    auto entry = std::find_if(entries_.begin(), entries_.end(),
                              [&](const Entry& candidate) { return candidate.folder == folder; });
    if (entry == entries_.end()) {
        entry = entries_.insert(entries_.end(), {folder, std::make_unique<MapLevels>(read_map(folder))});
        require_within_budget(level, pointer);
    }
    if (entry->map->kind != kind)
        throw Error({.what = fmt::format("the map \"{}\" is of the kind {}", name, facts_of(entry->map->kind).name),
                     .file = level.file.string(),
                     .pointer = pointer,
                     .expected = fmt::format("a map of the kind {}", facts_of(kind).name)});
    return static_cast<int>(entry - entries_.begin());
}

/// Takes the last map away again where all maps are too large.
void MapStore::require_within_budget(const Level& level, const std::string& pointer)
{
    try {
        Budget budget;
        for (const Entry& entry : entries_)
            budget.spend(Cost::map_pixels, texel_count(*entry.map), level.file.string(), pointer);
    } catch (const Error&) {
        entries_.pop_back();
        throw;
    }
}

std::vector<const MapLevels*> MapStore::maps() const
{
    std::vector<const MapLevels*> result;
    for (const Entry& entry : entries_) result.push_back(entry.map.get());
    return result;
}

std::vector<std::filesystem::path> MapStore::folders() const
{
    std::vector<std::filesystem::path> result;
    for (const Entry& entry : entries_) result.push_back(entry.folder);
    return result;
}

std::vector<std::string> MapStore::read_again()
{
    std::vector<std::string> messages;
    for (Entry& entry : entries_) {
        try {
            *entry.map = read_map(entry.folder);
        } catch (const std::exception& error) {
            messages.emplace_back(error.what());
        }
    }
    return messages;
}

}  // namespace hw
