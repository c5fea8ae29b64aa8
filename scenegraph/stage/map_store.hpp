#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hatchway/maps/map_levels.hpp"
#include "hatchway/world/level.hpp"

namespace hw {

/// The maps that a level uses, each read once. An index, once given, names the same map for good.
class MapStore {
 public:
    /// The index into maps() of a map that a level, or a style of it, names; reads it on first use. Throws hw::Error
    /// when there is no such map, it is damaged, of another kind, or too large with the others; `pointer` says where
    /// the name stands.
    int use(const Level& level, MapKind kind, const std::string& name, const std::string& pointer);

    /// For SceneInput::maps. The pointers stay; read_again() changes what they point at.
    std::vector<const MapLevels*> maps() const;
    std::vector<std::filesystem::path> folders() const;

    /// Reads every map anew. One that fails stays as it was and its message is returned.
    std::vector<std::string> read_again();

 private:
    struct Entry {
        std::filesystem::path folder;
        std::unique_ptr<MapLevels> map;
    };
    void require_within_budget(const Level& level, const std::string& pointer);

    std::vector<Entry> entries_;
};

}  // namespace hw
