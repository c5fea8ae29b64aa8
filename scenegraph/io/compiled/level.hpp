#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hatchway/geometry/mesh_chunks.hpp"
#include "hatchway/world/level.hpp"
#include "hatchway/world/scene.hpp"
#include "hatchway/world/visibility/visibility.hpp"

namespace hw {

/// Of the file's layout and of what build_visibility() makes of the same input: raised when either changes, so that old
/// files are compiled anew.
inline constexpr std::uint32_t kCompiledLevelVersion = 3;

/// A visibility and what it was made from. The same input gives the same bytes, for any number of threads.
struct CompiledLevel {
    std::uint64_t key = 0;
    PvsEffort effort = PvsEffort::full;
    Visibility visibility;
};

/// Where the compiled form of a level is kept: in the folder `.hatchway` beside the level, or in `cache_folder` under a
/// name of its own for each level. Throws hw::Error if `.hatchway` is a link that leaves the level's project.
std::filesystem::path compiled_level_path(const Level& level, const std::filesystem::path& cache_folder);

/// The compiled level at `file`, if there is one with this key and at least this effort. A damaged one is named in a
/// message; an outdated one is only passed over.
std::optional<CompiledLevel> find_compiled_level(const std::filesystem::path& file, std::uint64_t key, PvsEffort effort,
                                                 const Scene& scene, std::span<const MeshChunks> chunks_of_mesh);

/// Writes a compiled level where compiled_level_path() says; makes the last folder of the path if it is missing. Throws
/// hw::Error when that cannot be, and for a folder that nobody may write into.
void keep_compiled_level(const std::filesystem::path& file, const CompiledLevel& level,
                         std::span<const MeshChunks> chunks_of_mesh);

}  // namespace hw
