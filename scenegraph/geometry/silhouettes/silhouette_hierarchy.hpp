#pragma once

#include <cstdint>

#include "hatchway/geometry/silhouettes/silhouettes_private.hpp"

namespace hw {

/// Fills scratch.edges and returns the number of edges.
std::uint32_t search_clusters(const SilhouetteSearch& search, SilhouetteScratch& scratch);

}  // namespace hw
