#pragma once

#include <cstdint>
#include <vector>

#include "hatchway/geometry/surface/surface.hpp"

namespace hw {

/// Faces at an edge of more than two of which at least one has to be seen, not culled, for the edge to show: all but
/// those of the one plane that runs straight on across it, its faces wound alike. All of them where there is no such
/// plane, where there are two, where nothing else is there, and where there are so many that looking would be slow.
std::vector<std::uint32_t> faces_that_show(const Surface& surface, std::uint32_t edge);

}  // namespace hw
