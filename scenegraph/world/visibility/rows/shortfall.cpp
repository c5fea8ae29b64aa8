#include "hatchway/world/visibility/rows/shortfall.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <vector>

namespace hw {
namespace {

constexpr int kCells = 8;  // along each axis

int cell_of(double share)
{
    return std::clamp(static_cast<int>(share * kCells), 0, kCells - 1);
}

}  // namespace

Box densest_part(std::span<const glm::dvec3> places, const Box& bounds)
{
    if (places.empty() || bounds.is_empty()) return bounds;
    const glm::dvec3 size = glm::max(bounds.size(), glm::dvec3(1e-9));
    std::vector<int> counts(kCells * kCells * kCells, 0);
    for (const glm::dvec3& place : places) {
        const glm::dvec3 share = (place - bounds.min) / size;
        ++counts[static_cast<std::size_t>((cell_of(share.z) * kCells + cell_of(share.y)) * kCells + cell_of(share.x))];
    }
    const int best = static_cast<int>(std::max_element(counts.begin(), counts.end()) - counts.begin());
    const glm::dvec3 cell(best % kCells, best / kCells % kCells, best / kCells / kCells);
    const glm::dvec3 step = bounds.size() / static_cast<double>(kCells);
    return {bounds.min + cell * step, bounds.min + (cell + 1.0) * step};
}

std::string shortfall_text(const Shortfall& shortfall)
{
    const Box& box = shortfall.where_world;
    return fmt::format("{}; most of it from ({:.1f}, {:.1f}, {:.1f}) to ({:.1f}, {:.1f}, {:.1f})", shortfall.what,
                       box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z);
}

}  // namespace hw
