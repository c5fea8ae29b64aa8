#pragma once

#include <glm/vec2.hpp>

#include "hatchway/core/pixels.hpp"

namespace hw {

/// Size of a character's cell in texels of font_atlas(), and in logical pixels on the screen.
inline constexpr glm::ivec2 kGlyphTexels{6, 8};
inline constexpr glm::ivec2 kGlyphSize{12, 16};
inline constexpr int kGlyphColumns = 16;

/// All characters from ' ' to '~', kGlyphColumns in a row, and after the last a filled cell. One channel: 0 or 255.
Pixels font_atlas();

/// The cell of a character in the atlas, counted from the top left; characters that it lacks get that of '?'.
glm::ivec2 glyph_cell(char character);
glm::ivec2 filled_cell();

}  // namespace hw
