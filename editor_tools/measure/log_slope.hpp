#pragma once

#include <span>

namespace hw::measure {

/// Slope of the straight line of least squares through (log x, log y): 1 where y is proportional to x, 0 where it does
/// not depend on it. Both are positive, at least two x differ.
double log_slope(std::span<const double> x, std::span<const double> y);

}  // namespace hw::measure
