#include "hatchway/world/light/pack.hpp"

#include <algorithm>
#include <numeric>

#include "hatchway/core/error.hpp"

namespace hw {

Packing pack_in_rows(std::span<const glm::ivec2> sizes, int width)
{
    std::vector<std::size_t> order(sizes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return sizes[a].y != sizes[b].y ? sizes[a].y > sizes[b].y : sizes[a].x > sizes[b].x;
    });
    Packing packing;
    packing.corners.resize(sizes.size());
    glm::ivec2 next(0);
    for (const std::size_t i : order) {
        HW_ASSERT(sizes[i].x <= width);
        if (next.x + sizes[i].x > width) next = {0, packing.height};
        packing.corners[i] = next;
        next.x += sizes[i].x;
        packing.height = std::max(packing.height, next.y + sizes[i].y);
    }
    return packing;
}

}  // namespace hw
