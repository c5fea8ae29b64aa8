#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hatchway/geometry/mesh_chunks.hpp"
#include "hatchway/io/compiled/level.hpp"

namespace hw {

/// The bytes of a compiled level: one FlatBuffer, see compiled_level.fbs. `chunks_of_mesh` as build_visibility() had
/// it.
std::vector<std::byte> compiled_level_bytes(const CompiledLevel& level, std::span<const MeshChunks> chunks_of_mesh);

}  // namespace hw
