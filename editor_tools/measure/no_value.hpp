#pragma once

#include <limits>

namespace hw::measure {

/// What nothing was measured of: null in a result, a dash on the report's page, no point in a plot. Never 0, which is a
/// perfect error.
inline constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// No value where `whole` is 0.
inline double share_of(double part, double whole)
{
    return whole > 0.0 ? part / whole : kNoValue;
}

}  // namespace hw::measure
