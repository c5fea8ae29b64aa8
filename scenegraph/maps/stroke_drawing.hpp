#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "hatchway/core/pixels.hpp"

namespace hw {

/// A pen stroke on a map: a polyline in units of the map, (0, 0) to (1, 1), x right, y down. What leaves the map on one
/// side comes in on the other.
struct MapStroke {
    std::vector<glm::dvec2> points;  ///< At least one; one alone is a dot.
    double width = 1.0;              ///< Relative to the map's pen.
    double priority = 0.0;           ///< Strokes of low priority are the last to go when there is room for few.
};

/// Ink coverage of a map's level, each texel in [0, 1], rows from top to bottom.
struct InkPlane {
    InkPlane(int width_texels, int height_texels)
        : width(width_texels), height(height_texels), ink(static_cast<std::size_t>(width_texels) * height_texels)
    {
    }
    int width;
    int height;
    std::vector<float> ink;
    float& at(int x, int y) { return ink[static_cast<std::size_t>(y) * width + x]; }
    float at(int x, int y) const { return ink[static_cast<std::size_t>(y) * width + x]; }
};

/// Draws a stroke with a round pen `width_texels` wide, filtered by a box of one texel. Where strokes cross, the darker
/// stays: so a texel's ink never falls when strokes are added. Returns the ink that it added, summed over the texels.
double draw_stroke(InkPlane& plane, const MapStroke& stroke, double width_texels);

/// The mean ink of the plane: its tone.
double mean_ink(const InkPlane& plane);

/// As a map's level holds it: 0 ink, 255 paper.
Pixels level_of(const InkPlane& plane);
/// The inverse of level_of().
InkPlane plane_of(const Pixels& level);

/// The strokes by rising priority; equal ones in their order.
std::vector<MapStroke> by_priority(std::span<const MapStroke> strokes);

/// Gives strokes priorities that spread them evenly: long strokes first, each as far from the earlier ones as can be.
/// O(n^2) for n strokes up to 20,000; of more, the last are ranked by their distance to the first alone.
void rank_evenly(std::span<MapStroke> strokes);

}  // namespace hw
