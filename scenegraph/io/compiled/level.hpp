#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hatchway/geometry/mesh_chunks.hpp"
#include "hatchway/world/level.hpp"
#include "hatchway/world/scene.hpp"
#include "hatchway/world/visibility/visibility.hpp"

namespace hw {

class FolderHandle;

/// Of the file's layout and of what build_visibility() makes of the same input: raised when either changes, so that old
/// files are left aside.
inline constexpr std::uint32_t kCompiledLevelVersion = 5;

/// A visibility and what it was made from. The same input gives the same bytes, for any number of threads.
struct CompiledLevel {
    std::uint64_t key = 0;
    PvsEffort effort = PvsEffort::full;
    Visibility visibility;
    bool is_from_cache = false;  ///< Found, not made just now.
};

/// The file of a level in a cache folder: the same wherever the level is named from, another for each level and each
/// version of the compiler.
std::string compiled_level_name(const Level& level);

/// The compiled level in a cache folder, if there is one with this key and at least this effort. A damaged one, or a
/// link, is named in a message; an outdated one is only passed over. Only a folder that nobody else writes into is to
/// be believed: nothing here proves that the visibility is right.
std::optional<CompiledLevel> find_compiled_level(const FolderHandle& cache, const std::string& name, std::uint64_t key,
                                                 PvsEffort effort, const Scene& scene,
                                                 std::span<const MeshChunks> chunks_of_mesh);

}  // namespace hw
