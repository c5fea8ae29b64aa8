#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "hatchway/geometry/mesh_chunks.hpp"
#include "hatchway/io/compiled/level.hpp"

namespace hw {

/// A tree deeper than this is refused; what compiles is far from it.
inline constexpr int kMostTreeDepth = 4000;

/// Reads a compiled level. Verifies the FlatBuffer and its hash, then every count, index, range and number, also that
/// the nodes are one tree. Throws hw::Error that names `file` for whatever does not hold, for another version, and for
/// a scene with other objects or chunks. Does not look at the key.
CompiledLevel compiled_level_from_bytes(std::span<const std::byte> bytes, const Scene& scene,
                                        std::span<const MeshChunks> chunks_of_mesh, const std::string& file);

}  // namespace hw
