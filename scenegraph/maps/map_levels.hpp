#pragma once

#include <vector>

#include "hatchway/core/pixels.hpp"
#include "hatchway/param/param_visitor.hpp"

namespace hw {

/// A hatch, ink or tonal map with its levels as its maker drew them, finest first. Values are linear: 0 ink, 255 paper.
/// A hatch map is one texel high; each level is half as wide as the one before, rounded down, and half as high (never
/// below 1). Tonal maps hold their tones side by side, darkest last.
struct MapLevels {
    MapKind kind = MapKind::ink;
    std::vector<Pixels> levels;   ///< One channel each; never empty.
    double size_m = 1.0;          ///< Width of the map on a surface, metres.
    double spacing_texels = 8.0;  ///< Between two lines, in texels of the finest level.
};

}  // namespace hw
