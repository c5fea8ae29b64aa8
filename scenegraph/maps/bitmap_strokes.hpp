#pragma once

#include <vector>

#include "hatchway/core/pixels.hpp"
#include "hatchway/maps/stroke_drawing.hpp"

namespace hw {

/// How a drawing in pixels is read as strokes.
struct BitmapStrokesDesc {
    double ink_below = 0.5;    ///< Darker pixels are ink: 0 black, 1 white.
    double burr_widths = 1.0;  ///< Ends shorter than this many widths of their line are burrs of thinning.
};

/// The strokes of a drawing: its middle lines, continued straight over crossings. Widths are relative to the median
/// one. Priorities are even: see rank_evenly(). Lines that leave the drawing on one side go on at the other. No ink
/// gives no strokes. Throws hw::Error where noise would be more strokes than a budget has (core/budget.hpp).
std::vector<MapStroke> strokes_of_bitmap(const Pixels& drawing, const BitmapStrokesDesc& desc = {});

}  // namespace hw
