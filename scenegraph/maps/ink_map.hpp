#pragma once

#include <span>

#include "hatchway/maps/map_levels.hpp"
#include "hatchway/maps/stroke_drawing.hpp"

namespace hw {

/// How an ink map is drawn from strokes.
struct InkMapDesc {
    int width_texels = 512;  ///< Of the finest level; powers of two.
    int height_texels = 512;
    double pen_texels = 1.6;  ///< Width of a stroke of width 1, the same at every level.
    double size_m = 1.0;      ///< Width of the map on a surface.
    int smallest_texels = 8;  ///< Levels narrower than this are even gray.
};

/// How many strokes each level shows, beside the map.
struct InkMap {
    MapLevels map;
    std::vector<std::size_t> stroke_counts;  ///< One for each level; 0 where it is gray.
};

/// Draws every level anew with the same pen: coarser levels show fewer strokes, taken by priority, so many that the
/// level has the tone of the finest. So strokes neither thin out to gray nor run together, and a coarser level's
/// strokes are a part of the finer level's. Levels in which not even one stroke fits the tone, and all below, are paper
/// of that tone. The paper of 2001 does this by hand (section 3.2.2, figure 10).
InkMap make_ink_map(std::span<const MapStroke> strokes, const InkMapDesc& desc);

/// Ordinary levels, for comparison: each texel is the mean, or the darkest, of the four above it.
MapLevels filtered_by_mean(const Pixels& finest, double size_m);
MapLevels filtered_by_minimum(const Pixels& finest, double size_m);

}  // namespace hw
