#pragma once

#include <filesystem>

#include "hatchway/core/vector_drawing.hpp"

namespace hw {

/// The drawing as a page of PDF, 96 pixels an inch, drawn by cairo. Throws hw::Error when the file cannot be written.
void write_pdf(const std::filesystem::path& file, const VectorDrawing& drawing);

}  // namespace hw
