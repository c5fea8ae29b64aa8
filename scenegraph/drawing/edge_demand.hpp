#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hatchway/drawing/styled_object.hpp"

namespace hw {

/// Which edges the styles of one object draw.
struct EdgeDemand {
    std::vector<float> crease_rad;   ///< Of each style that draws edges, rising, none twice. Empty: no edges.
    bool has_intersections = false;  ///< A style draws where the object goes through others.
    std::uint32_t style_group = 0;   ///< Objects of one group hide each other's seams.

    bool is_any() const { return !crease_rad.empty(); }
};

/// One for each object. `needs`: of each style that the objects name.
std::vector<EdgeDemand> edge_demands(std::span<const StyledObject> objects, std::span<const Needs> needs);

}  // namespace hw
