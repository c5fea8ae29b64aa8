#pragma once

#include <cstdint>

#include "hatchway/maps/map_levels.hpp"

namespace hw {

/// How a tonal map is drawn. Equal descriptions give equal bytes.
struct TonalMapDesc {
    int size_texels = 256;          ///< Of one tone of the finest level, a power of two.
    int tones = 6;                  ///< Ink coverages 1/tones, 2/tones, ... 1.
    double pen_texels = 1.6;        ///< Width of a stroke, the same at every level.
    double length_share = 0.45;     ///< Mean length of strokes, of the map's width.
    double angle_spread_deg = 3.0;  ///< How far strokes stray from their direction.
    double cross_angle_deg = 70.0;  ///< Direction of the strokes that the darker half of the tones adds.
    double size_m = 1.0;            ///< Width of one tone on a surface.
    int smallest_texels = 16;       ///< Levels narrower than this are even grays.
    std::uint32_t seed = 1;
};

/// A tonal map: in each level the tones side by side, darkest last. Strokes are nested both ways: what a lighter tone
/// or a coarser level shows is in every darker tone and finer level too, so tones and levels blend without strokes that
/// come and go. Each level of each tone has its exact coverage, but for the last stroke. Source: Praun, Hoppe, Webb,
/// Finkelstein. Real-Time Hatching. SIGGRAPH 2001, section 3.
MapLevels make_tonal_map(const TonalMapDesc& desc);

/// A priority map: one square whose values say at which tone each texel turns to ink, from the nested tones of
/// make_tonal_map(): 0 in all of them, 255 in none. Priorities are spread evenly, so that a threshold gives the tone.
/// A tonal map of a single tone. Source: Freudenberg, Masuch, Strothotte. Real-Time Halftoning. EGWR 2002.
MapLevels make_priority_map(const TonalMapDesc& desc);

}  // namespace hw
