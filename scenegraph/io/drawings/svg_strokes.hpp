#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace hw {

/// A stroke of a drawing: a polyline in units of the drawing's width, x right, y down.
struct SvgStroke {
    std::vector<glm::dvec2> points;
    double width = 1.0;     ///< stroke-width, relative to the drawing's first stroke.
    double priority = 0.0;  ///< data-priority; low ones are kept longest.
    bool has_priority = false;
};

struct SvgDrawing {
    std::vector<SvgStroke> strokes;
    double height_share = 1.0;  ///< Height / width of the drawing.
};

/// Reads the strokes of an SVG file: <path> with M L H V C S Q Z in upper and lower case, <line>, <polyline>,
/// <polygon>, with the attributes stroke-width and data-priority, inside the viewBox (or width and height). Curves
/// become polylines of at most 1/1000 of the width per piece. Fills, transforms, styles and everything else are passed
/// over, shapes and transforms with a warning. Throws hw::Error for a file that is no SVG, a number that is none, or no
/// strokes; limits: 4 MiB, 100,000 strokes, 200,000 points, all strokes together 4,000 times as long as it is wide, no
/// point farther than 100,000 widths, at most 256 times as high as wide or as wide as high.
SvgDrawing read_svg_strokes(const std::filesystem::path& file);
SvgDrawing parse_svg_strokes(const std::string& text, const std::string& file);

}  // namespace hw
