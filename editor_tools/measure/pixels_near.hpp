#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace hw {

/// Calls `use(x, y, distance)` for the pixels of a picture whose middle is within `reach_px` of a place. Origin top
/// left.
template <typename Use>
void for_each_pixel_near(const glm::dvec2& at_px, double reach_px, glm::ivec2 size_px, const Use& use)
{
    const glm::ivec2 low = glm::max(glm::ivec2(glm::floor(at_px - reach_px)), glm::ivec2(0));
    const glm::ivec2 high = glm::min(glm::ivec2(glm::floor(at_px + reach_px)), size_px - 1);
    for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x) {
            const double distance = glm::distance(at_px, glm::dvec2(x + 0.5, y + 0.5));
            if (distance <= reach_px) use(x, y, distance);
        }
}

}  // namespace hw
