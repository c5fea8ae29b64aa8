#pragma once

#include <filesystem>
#include <string>

#include "hatchway/core/vector_drawing.hpp"

namespace hw {

/// The drawing as SVG 1.1: a sheet of paper; above it one group for each object, and in it one for each line type. An
/// object's group has the class "object" and a class made of its name (letters, digits and '_', made different from all
/// before); a line group has the class of its object and its line type, hidden ones "hidden" too: style sheets can
/// reach every object, every line type and both together. Inkscape shows the groups as layers. Coordinates have two
/// decimals, lines are sorted within their group: equal drawings are equal bytes, whatever order their lines were found
/// in. Lines shorter than a hundredth of a pixel are left out.
std::string svg_text(const VectorDrawing& drawing);
void write_svg(const std::filesystem::path& file, const VectorDrawing& drawing);

}  // namespace hw
