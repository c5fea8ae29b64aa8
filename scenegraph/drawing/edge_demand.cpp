#include "hatchway/drawing/edge_demand.hpp"

#include <algorithm>

namespace hw {
namespace {

void add_need(EdgeDemand& demand, const EdgeNeed& need)
{
    const auto at = std::lower_bound(demand.crease_rad.begin(), demand.crease_rad.end(), need.crease_rad);
    if (at == demand.crease_rad.end() || *at != need.crease_rad) demand.crease_rad.insert(at, need.crease_rad);
    demand.has_intersections = demand.has_intersections || need.intersections;
}

}  // namespace

std::vector<EdgeDemand> edge_demands(std::span<const StyledObject> objects, std::span<const Needs> needs)
{
    std::vector<EdgeDemand> demands;
    demands.reserve(objects.size());
    for (const StyledObject& object : objects) {
        EdgeDemand& demand = demands.emplace_back();
        demand.style_group = static_cast<std::uint32_t>((object.style + 1) * 65536 + object.over + 1);
        for (const int style : {object.style, object.over})
            if (style != kNone && needs[style].edges) add_need(demand, *needs[style].edges);
    }
    return demands;
}

}  // namespace hw
