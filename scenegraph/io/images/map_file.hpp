#pragma once

#include <filesystem>
#include <string>

#include "hatchway/maps/map_levels.hpp"
#include "hatchway/world/level.hpp"

namespace hw {

/// Reads a map: a folder with map.json and its levels level_0.png (finest), level_1.png, ...
/// map.json: {"format": "hatchway-map/1", "kind": "hatch" | "ink" | "tonal", "levels": 6, "size_m": 1.2,
/// "spacing_texels": 8}. Throws hw::Error when a file is missing or is no 8-bit gray image, when a level is not half
/// the one before, or when a hatch map is over one texel high.
MapLevels read_map(const std::filesystem::path& folder);

/// The folder of a map that a level names. A plain name ([a-z0-9_]+) is one of the maps that come with the program,
/// maps/<kind>/<name>; anything else is a path relative to the level file, inside its project. Throws hw::Error when
/// there is no such map; `pointer` says where the level names it.
std::filesystem::path find_map(const Level& level, MapKind kind, const std::string& name, const std::string& pointer);

}  // namespace hw
