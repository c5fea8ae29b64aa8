#pragma once

#include <filesystem>
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

/// What is drawn of one object. Hatching is to become groups before those of its lines. Fills are to become a list of
/// their own in VectorDrawing, below all lines: what is seen of each object, as shapes that do not overlap.
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

/// The drawing as SVG 1.1: a sheet of paper; above it one group for each object, and in it one for each line type. An
/// object's group has the class "object" and a class made of its name (letters, digits and '_', made different from all
/// before); a line group has the class of its object and its line type, hidden ones "hidden" too: style sheets can
/// reach every object, every line type and both together. Inkscape shows the groups as layers. Coordinates have two
/// decimals, lines are sorted within their group: equal drawings are equal bytes, whatever order their lines were found
/// in. Lines shorter than a hundredth of a pixel are left out.
std::string svg_text(const VectorDrawing& drawing);
void write_svg(const std::filesystem::path& file, const VectorDrawing& drawing);

/// The same drawing as a page of PDF, 96 pixels an inch, drawn by cairo. Throws hw::Error when the file cannot be
/// written.
void write_pdf(const std::filesystem::path& file, const VectorDrawing& drawing);

/// What a line of the drawing comes to once it is rounded to hundredths of a pixel: no point twice in a row. Less than
/// two points: nothing to draw.
std::vector<glm::dvec2> rounded_points(const VectorLine& line);

}  // namespace hw
