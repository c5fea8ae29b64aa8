#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "hatchway/drawing/edge_demand.hpp"
#include "hatchway/drawing/scene_surfaces.hpp"
#include "hatchway/geometry/lines/intersections.hpp"
#include "hatchway/geometry/lines/seams.hpp"

namespace hw {

/// A piece of the line where an object goes through another, object space.
struct ObjectIntersection {
    std::array<glm::vec3, 2> ends{};
    std::uint32_t index = 0;  ///< Into LineExtras::intersections.
    /// Unit normals of the two faces that are not drawn where they look away; zero: the face is always drawn.
    std::array<glm::vec3, 2> culled_normals{};
};

/// What the lines of an object have beside the edges of its own surface.
struct ObjectExtras {
    Seams seams;  ///< Edges that are left out, and the pieces of them that are kept.
    std::vector<ObjectIntersection> intersections;

    bool is_empty() const
    {
        return intersections.empty() && seams.hidden.empty() && seams.partly_hidden.empty() && seams.kept.empty();
    }
};

/// The same of all objects of a scene.
struct LineExtras {
    std::vector<ObjectExtras> objects;
    std::vector<IntersectionLine> intersections;  ///< By ObjectId, as for find_visible_lines().
};

/// Finds where objects that show intersections go through any other: such a line belongs to the first of the two that
/// shows it. `demands`: one for each object. Builds the surfaces that it needs.
LineExtras find_intersection_extras(const Scene& scene, std::span<const EdgeDemand> demands, SceneSurfaces& surfaces);

/// The same, and the seams of objects of one style group.
LineExtras find_line_extras(const Scene& scene, std::span<const EdgeDemand> demands, SceneSurfaces& surfaces);

}  // namespace hw
