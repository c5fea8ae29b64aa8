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

/// A tree deeper than this is refused; what compiles is far from it.
inline constexpr int kMostTreeDepth = 4000;

/// Of all that a level's visibility is made from: the scene's geometry as split_into_chunks() left it, what of it is
/// opaque, double-sided or animated, the level's structure, and the options without effort, threads and budget.
std::uint64_t compiled_level_key(const Scene& scene, const Level& level, const VisibilityOptions& options);

/// A visibility and what it was made from. The same input gives the same bytes, for any number of threads.
struct CompiledLevel {
    std::uint64_t key = 0;
    PvsEffort effort = PvsEffort::full;
    Visibility visibility;
};

/// The bytes of a compiled level: one FlatBuffer, see compiled_level.fbs. `chunks_of_mesh` as build_visibility() had
/// it.
std::vector<std::byte> compiled_level_bytes(const CompiledLevel& level, std::span<const MeshChunks> chunks_of_mesh);

/// Reads a compiled level. Verifies the FlatBuffer and its hash, then every count, index, range and number, also that
/// the nodes are one tree. Throws hw::Error that names `file` for whatever does not hold, for another version, and for
/// a scene with other objects or chunks. Does not look at the key.
CompiledLevel compiled_level_from_bytes(std::span<const std::byte> bytes, const Scene& scene,
                                        std::span<const MeshChunks> chunks_of_mesh, const std::string& file);

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
