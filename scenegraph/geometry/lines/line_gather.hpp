#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "hatchway/geometry/lines/image_space.hpp"
#include "hatchway/geometry/silhouettes/silhouettes.hpp"

namespace hw {

/// A straight line of the drawing before its hidden parts are removed: what the picture shows of it.
struct DrawnLine {
    std::uint32_t object = 0;
    std::uint8_t set = 0;
    LineClass line_class = LineClass::silhouette;
    /// Of the surface, or joints of intersections; kFreeEnd where it is a part of an edge.
    std::array<std::uint32_t, 2> vertices{};
    std::array<std::uint32_t, 2> faces{};  ///< Numbers among all faces; kNoFace where there is none.
    bool is_rounded = false;               ///< A face beside it is a needle: floats do not tell where that lies.
    ImageLine image;
    LineSource source;
};

/// A line at which visibility can change behind it: a silhouette, a border, or where the near plane cuts a face.
struct ContourLine {
    ImagePoint from{0.0};
    ImagePoint to{0.0};
};

/// An object as the picture shows it. Spans are parts of the drawing's vectors.
struct DrawnObject {
    const Surface* surface = nullptr;
    Viewpoint eye_object;
    std::uint32_t first_face = 0;  ///< The number of its face 0 among all.
    bool hides = false;
    double contact_m = 0.0;            ///< What enters it by less only touches it.
    bool is_in_picture = false;        ///< Else nothing more is known of it.
    bool is_cut = false;               ///< By the near plane.
    std::span<glm::dvec3> view;        ///< Of each position, view space.
    std::span<ImagePoint> image;       ///< ... of those before the near plane.
    std::span<std::uint8_t> is_there;  ///< Of each face, where those that look away are not there; else empty.
};

/// All that a drawing is made from, in the order of the objects. Moves keep the spans.
struct LineDrawing {
    std::vector<glm::dvec3> view;
    std::vector<ImagePoint> image;
    std::vector<std::uint8_t> is_there;
    std::vector<DrawnObject> objects;
    std::vector<ContourLine> contours;
    std::vector<DrawnLine> lines;
};

LineDrawing gather_lines(std::span<const LineObject> objects, const ImageSpace& space,
                         const VisibleLineOptions& options);

}  // namespace hw
