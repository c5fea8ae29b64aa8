#include "measure/picture_difference.hpp"

#include <algorithm>

#include "hatchway/core/error.hpp"

namespace hw::measure {

double unlike_share(const Pixels& a, const Pixels& b)
{
    HW_ASSERT(a.width == b.width && a.height == b.height && a.channels == b.channels);
    std::size_t count = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) count += !std::equal(a.at(x, y), a.at(x, y) + a.channels, b.at(x, y));
    return static_cast<double>(count) / (static_cast<double>(a.width) * a.height);
}

}  // namespace hw::measure
