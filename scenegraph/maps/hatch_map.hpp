#pragma once

#include "hatchway/maps/map_levels.hpp"

namespace hw {

/// How a hatch map's lines are drawn. One texel becomes about one logical pixel.
struct HatchMapDesc {
    int width_texels = 2048;    ///< Of the finest level, a power of two: 2^n gives n + 1 levels.
    int spacing_texels = 8;     ///< Between two lines at every level, a power of two.
    double line_texels = 1.25;  ///< Width of a line, at most the spacing.
};

/// A hatch map, N x 1 texels: parallel lines, equally far apart in texels at every level, so that a line of the next
/// coarser level lies exactly on every second one. Levels too narrow to hold a line are gray with the same tone.
/// Coverage is exact: each texel holds the share of it that lies in a line. All levels have one mean.
/// Source: Freudenberg, Masuch, Strothotte. Walk-Through Illustrations. Eurographics 2001, section 3.2.1, figure 6.
MapLevels make_hatch_map(const HatchMapDesc& desc);

}  // namespace hw
