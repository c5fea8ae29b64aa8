#pragma once

#include <vector>

#include "hatchway/core/pixels.hpp"
#include "hatchway/param/param_visitor.hpp"

namespace hw {

/// A map with its levels as its maker drew them, finest first. Values of hatch, ink and tonal maps are linear: 0 ink,
/// 255 paper; those of ramps and images are sRGB. Each level is half as wide as the one before, rounded down, and half
/// as high (never below 1). Tonal maps hold their tones side by side, darkest last; ramps their colours, dark ones
/// first.
struct MapLevels {
    MapKind kind = MapKind::ink;
    std::vector<Pixels> levels;   ///< Never empty. One channel each, but for kinds in colour.
    double size_m = 1.0;          ///< Width of the map on a surface, metres.
    double spacing_texels = 8.0;  ///< Between two lines, in texels of the finest level.
};

}  // namespace hw
