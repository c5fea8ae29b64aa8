#include "hatchway/stage/map_store.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hatchway/core/error.hpp"
#include "hatchway/io/images/map_file.hpp"

namespace hw {

int MapStore::use(const Level& level, MapKind kind, const std::string& name, const std::string& pointer)
{
    const std::filesystem::path folder = find_map(level, kind, name, pointer);
    auto entry = std::find_if(entries_.begin(), entries_.end(),
                              [&](const Entry& candidate) { return candidate.folder == folder; });
    if (entry == entries_.end())
        entry = entries_.insert(entries_.end(), {folder, std::make_unique<MapLevels>(read_map(folder))});
    if (entry->map->kind != kind)
        throw Error({.what = fmt::format("the map \"{}\" is of the kind {}", name, facts_of(entry->map->kind).name),
                     .file = level.file.string(),
                     .pointer = pointer,
                     .expected = fmt::format("a map of the kind {}", facts_of(kind).name)});
    return static_cast<int>(entry - entries_.begin());
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
        } catch (const Error& error) {
            messages.emplace_back(error.what());
        }
    }
    return messages;
}

}  // namespace hw
