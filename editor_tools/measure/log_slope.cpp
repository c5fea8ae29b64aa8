#include "measure/log_slope.hpp"

#include <cmath>

#include "hatchway/core/error.hpp"

namespace hw::measure {

double log_slope(std::span<const double> x, std::span<const double> y)
{
    HW_ASSERT(x.size() == y.size() && x.size() >= 2);
    double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        HW_ASSERT(x[i] > 0.0 && y[i] > 0.0);
        const double u = std::log(x[i]), v = std::log(y[i]);
        sx += u, sy += v, sxx += u * u, sxy += u * v;
    }
    const double n = static_cast<double>(x.size());
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace hw::measure
