#pragma once

#include <cstdint>

#include "hatchway/io/compiled/level.hpp"

namespace hw {

/// Of a scene's geometry as split_into_chunks() left it, without a lightmap's stream, and of what of it is opaque,
/// double-sided or animated.
std::uint64_t geometry_key(const Scene& scene);

/// Of all that a level's visibility is made from: geometry_key() of the whole scene, what is hidden of it now, the
/// level's structure among the scene's nodes, and
/// the options without effort, threads and budget.
std::uint64_t compiled_level_key(std::uint64_t geometry_key, const Scene& scene, const Level& level,
                                 const VisibilityOptions& options);

}  // namespace hw
