#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/image_space.hpp"
#include "geometry/silhouettes.hpp"

namespace hw {

/// A straight line of the drawing before its hidden parts are removed.
struct DrawnLine {
    std::uint32_t object = 0;
    VisibleLineClass line_class = VisibleLineClass::silhouette;
    /// Of the surface, or joints of intersections; kFreeEnd where it is a part of an edge.
    std::array<std::uint32_t, 2> vertices{};
    std::array<std::uint32_t, 2> faces{};  ///< Numbers among all faces; kNoFace where there is none.
    glm::dvec3 from_view{0.0};
    glm::dvec3 to_view{0.0};
    bool is_edge = true;  ///< A whole edge of the object's surface.
};

/// A line at which visibility can change behind it.
struct ContourLine {
    ImagePoint from{0.0};
    ImagePoint to{0.0};
};

/// An object as exact predicates need it.
struct DrawnObject {
    const Surface* surface = nullptr;
    Viewpoint eye_object;
    std::uint32_t first_face = 0;  ///< The number of its face 0 among all.
};

/// All that a drawing is made from, in the order of the objects.
struct LineDrawing {
    std::vector<DrawnObject> objects;
    std::vector<ImageTriangle> triangles;
    std::vector<ContourLine> contours;
    std::vector<DrawnLine> lines;
};

LineDrawing gather_lines(std::span<const LineObject> objects, const LineCamera& camera, const ImageSpace& space,
                         const VisibleLineOptions& options);

}  // namespace hw
