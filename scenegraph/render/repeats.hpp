#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hatchway/drawing/styled_object.hpp"

namespace hw {

/// For each object, 1 where a later one has the same mesh, material, look and transform: it lies in each of its pixels
/// and is drawn after it, so that drawing this one, too, changes none. What is blended repeats nothing.
std::vector<std::uint8_t> find_repeats(const Scene& scene, std::span<const StyledObject> looks);

}  // namespace hw
