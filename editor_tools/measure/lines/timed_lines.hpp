#pragma once

#include <span>
#include <vector>

#include "hatchway/geometry/lines/visible_lines.hpp"

namespace hw {

/// find_visible_lines() so many times; `seconds` becomes the median time of one.
std::vector<VisibleLine> timed_visible_lines(std::span<const LineObject> objects, const LineCamera& camera,
                                             const VisibleLineOptions& options, int runs, double& seconds);

}  // namespace hw
