#pragma once

#include <filesystem>
#include <optional>

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

/// Compiles the visibility of a world's scene; with a progress bar where `options` tell nobody.
CompiledLevel compile_world(const Level& level, const LevelWorld& world, const VisibilityOptions& options);

/// What the cache holds of it, made from the same input. What lies beside the level is not looked at: it came with the
/// level.
std::optional<CompiledLevel> find_compiled_world(const Level& level, const LevelWorld& world,
                                                 const VisibilityOptions& options, const CompiledCache& cache);

/// find_compiled_world(), or else compile_world(), which is kept in the cache. Where nothing can be kept, one message
/// says so. `cache` may be null.
CompiledLevel find_or_compile_world(const Level& level, const LevelWorld& world, const VisibilityOptions& options,
                                    const CompiledCache* cache);

}  // namespace hw
