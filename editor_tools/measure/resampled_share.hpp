#pragma once

#include <span>
#include <utility>

namespace hw::measure {

struct ShareRange {
    double low = 0.0;
    double high = 0.0;
};

/// How far the quotient of two sums hangs on which parts are in them: 95 % of the quotients when as many parts are
/// drawn anew, with repeats. First: the numerator's. Needs a part with a denominator; else both ends are kNoValue.
/// Method: bootstrap, percentiles. Source: Efron. Bootstrap Methods. 1979.
ShareRange resampled_share(std::span<const std::pair<double, double>> parts);

}  // namespace hw::measure
