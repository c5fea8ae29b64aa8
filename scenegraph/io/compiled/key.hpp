#pragma once

#include <cstdint>

#include "hatchway/io/compiled/level.hpp"

namespace hw {

/// Of all that a level's visibility is made from: the scene's geometry as split_into_chunks() left it, what of it is
/// opaque, double-sided or animated, the level's structure, and the options without effort, threads and budget.
std::uint64_t compiled_level_key(const Scene& scene, const Level& level, const VisibilityOptions& options);

}  // namespace hw
