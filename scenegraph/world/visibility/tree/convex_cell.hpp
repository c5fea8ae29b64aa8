#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "hatchway/core/box.hpp"
#include "hatchway/world/visibility/tree/portal_polygon.hpp"

namespace hw {

/// A convex piece of space as its faces, in floating point: for sizes, not for decisions that must be exact.
class ConvexCell {
 public:
    explicit ConvexCell(const Box& box);

    /// The part in front of the plane; empty if the cell does not reach there.
    ConvexCell in_front_of(const FlowPlane& plane) const;
    bool is_empty() const { return faces_.empty(); }
    Box bounds() const;
    const std::vector<std::vector<glm::dvec3>>& faces() const { return faces_; }

 private:
    ConvexCell() = default;
    std::vector<std::vector<glm::dvec3>> faces_;
};

}  // namespace hw
