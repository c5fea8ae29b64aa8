#pragma once

#include "hatchway/core/pixels.hpp"

namespace hw {

/// What one level of an ink map shows. Ink is linear coverage, 0 paper, 1 ink.
struct InkLevelFigures {
    double stroke_texels = 0.0;  ///< Median width of strokes, across them; 0 where no stroke stands out.
    double tone = 0.0;           ///< Mean ink.
    double contrast = 0.0;       ///< Darkest less lightest texel.
};

/// Measures a gray level, 0 ink, 255 paper; the level repeats beyond its borders.
InkLevelFigures ink_level_figures(const Pixels& level);

}  // namespace hw
