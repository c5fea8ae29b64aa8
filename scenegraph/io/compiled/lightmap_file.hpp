#pragma once

#include <filesystem>
#include <optional>

#include "hatchway/world/light/lightmap.hpp"

namespace hw {

/// Where a level's lightmap is looked for: beside the level, its name with ".lightmap" at the end.
std::filesystem::path lightmap_path(const std::filesystem::path& level_file);

/// Writes a lightmap; readers see the old file or the new one. A link is replaced. Throws hw::Error when the folder is
/// not writable.
void write_lightmap(const std::filesystem::path& file, const Lightmap& lightmap);

/// Reads and checks a lightmap. Throws hw::Error for a damaged file, one of another version, one that does not fit the
/// scene, and a link.
Lightmap read_lightmap(const std::filesystem::path& file, const Scene& scene);

/// The level's lightmap, if there is one that fits. One that does not is named in a warning and left alone: the level
/// is shown without.
std::optional<Lightmap> find_lightmap(const std::filesystem::path& level_file, const Scene& scene);

}  // namespace hw
