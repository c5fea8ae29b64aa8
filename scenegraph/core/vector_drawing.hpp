#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace hw {

/// A polyline in pixels, origin top left, y down.
struct VectorLine {
    std::vector<glm::dvec2> points_px;
    bool is_closed = false;  ///< The first point is not repeated.
    double width_px = 1.0;   ///< Above 0.
};

/// The lines of one type of one object: a layer of the drawing.
struct VectorGroup {
    std::string line_type;   ///< [a-z_]+, such as "silhouette".
    bool is_hidden = false;  ///< Drawn dashed.
    double width_px = 1.0;   ///< Of lines that have none of their own.
    double opacity = 1.0;
    glm::vec3 colour_srgb{0.0f};
    std::vector<VectorLine> lines;
};

/// What is drawn of one object.
struct VectorObject {
    std::string name;  ///< As people know it, such as "Hall/Column_03".
    std::vector<VectorGroup> groups;
};

/// A line drawing as vectors, in the order in which it is drawn.
struct VectorDrawing {
    glm::ivec2 size_px{0};
    glm::vec3 paper_srgb{1.0f};
    std::string title;
    std::vector<VectorObject> objects;
};

/// What a line of the drawing comes to once it is rounded to hundredths of a pixel: no point twice in a row. Less than
/// two points: nothing to draw.
std::vector<glm::dvec2> rounded_points(const VectorLine& line);

}  // namespace hw
