#pragma once

#include <filesystem>

#include "hatchway/io/compiled/level.hpp"

namespace hw {

struct LevelWorld;  // walk/level_world.hpp

/// Compiled levels are kept and found again.
struct CompiledCache {
    std::filesystem::path folder;  ///< Empty: `.hatchway` beside each level.
};

/// Compiles the visibility of a world's scene, with a progress bar.
CompiledLevel compile_world(const Level& level, const LevelWorld& world, const VisibilityOptions& options);

/// The same, but taken from the cache where it is there and made from the same input; else it is kept there. Where
/// nothing can be kept, a message says so.
CompiledLevel find_or_compile_world(const Level& level, const LevelWorld& world, const VisibilityOptions& options,
                                    const CompiledCache& cache);

}  // namespace hw
