#pragma once

#include "hatchway/core/pixels.hpp"

namespace hw::measure {

/// The share of pixels in which two pictures of one size differ, by however little.
double unlike_share(const Pixels& a, const Pixels& b);

}  // namespace hw::measure
