#pragma once

#include <filesystem>

#include "hatchway/core/files/folder_handle.hpp"
#include "hatchway/io/compiled/level.hpp"

namespace hw {

struct LevelWorld;  // level_world.hpp

/// Compiled levels are kept and found again.
struct CompiledCache {
    std::filesystem::path folder;  ///< Empty: the user's own cache folder.
};

/// The cache's folder, made when it is missing. Throws hw::Error when it cannot be, or is a link.
FolderHandle opened_cache(const CompiledCache& cache);

/// Compiles the visibility of a world's scene, with a progress bar.
CompiledLevel compile_world(const Level& level, const LevelWorld& world, const VisibilityOptions& options);

/// The same, but taken from the cache where it is there and made from the same input; else it is kept there. Where
/// nothing can be kept, one message says so. What lies beside the level is not looked at: it came with the level.
CompiledLevel find_or_compile_world(const Level& level, const LevelWorld& world, const VisibilityOptions& options,
                                    const CompiledCache& cache);

}  // namespace hw
