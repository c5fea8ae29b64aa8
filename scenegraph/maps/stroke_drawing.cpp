#include "hatchway/maps/stroke_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

int wrapped(int i, int size)
{
    return ((i % size) + size) % size;
}

double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b)
{
    const glm::dvec2 d = b - a;
    const double length_squared = glm::dot(d, d);
    const double t = length_squared > 0.0 ? std::clamp(glm::dot(p - a, d) / length_squared, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + t * d);
}

/// Segment in texels. The pen's edge is a ramp one texel wide, at full ink no higher than the pen is wide.
void draw_segment(InkPlane& plane, const glm::dvec2& a, const glm::dvec2& b, double width)
{
    const double reach = 0.5 * width + 0.5;
    const int x0 = static_cast<int>(std::floor(std::min(a.x, b.x) - reach));
    const int x1 = static_cast<int>(std::ceil(std::max(a.x, b.x) + reach));
    const int y0 = static_cast<int>(std::floor(std::min(a.y, b.y) - reach));
    const int y1 = static_cast<int>(std::ceil(std::max(a.y, b.y) + reach));
    for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
            const double distance = distance_to_segment(glm::dvec2(x + 0.5, y + 0.5), a, b);
            const float ink = static_cast<float>(std::clamp(reach - distance, 0.0, std::min(width, 1.0)));
            float& texel = plane.at(wrapped(x, plane.width), wrapped(y, plane.height));
            texel = std::max(texel, ink);
        }
    }
}

double length_of(const MapStroke& stroke)
{
    double length = 0.0;
    for (std::size_t i = 1; i < stroke.points.size(); ++i)
        length += glm::distance(stroke.points[i - 1], stroke.points[i]);
    return length;
}

/// Distance of two places on a map whose opposite sides touch.
double wrapped_distance(const glm::dvec2& a, const glm::dvec2& b)
{
    const glm::dvec2 d = a - b;
    return glm::length(d - glm::round(d));
}

}  // namespace

void draw_stroke(InkPlane& plane, const MapStroke& stroke, double width_texels)
{
    HW_ASSERT(!stroke.points.empty());
    const glm::dvec2 size(plane.width, plane.height);
    const double width = width_texels * stroke.width;
    const std::size_t count = stroke.points.size();
    for (std::size_t i = 0; i + 1 < std::max<std::size_t>(count, 2); ++i)
        draw_segment(plane, stroke.points[i] * size, stroke.points[std::min(i + 1, count - 1)] * size, width);
}

double mean_ink(const InkPlane& plane)
{
    return std::accumulate(plane.ink.begin(), plane.ink.end(), 0.0) / static_cast<double>(plane.ink.size());
}

Pixels level_of(const InkPlane& plane)
{
    Pixels level{.width = plane.width, .height = plane.height, .channels = 1};
    level.bytes.reserve(plane.ink.size());
    for (const float ink : plane.ink)
        level.bytes.push_back(static_cast<std::uint8_t>(std::lround(255.0f * (1.0f - std::clamp(ink, 0.0f, 1.0f)))));
    return level;
}

InkPlane plane_of(const Pixels& level)
{
    HW_ASSERT(level.channels == 1);
    InkPlane plane(level.width, level.height);
    std::ranges::transform(level.bytes, plane.ink.begin(), [](std::uint8_t paper) { return 1.0f - paper / 255.0f; });
    return plane;
}

std::vector<MapStroke> by_priority(std::span<const MapStroke> strokes)
{
    std::vector<MapStroke> sorted(strokes.begin(), strokes.end());
    std::ranges::stable_sort(sorted, {}, &MapStroke::priority);
    return sorted;
}

void rank_evenly(std::span<MapStroke> strokes)
{
    const std::size_t count = strokes.size();
    std::vector<glm::dvec2> middles;
    std::vector<double> lengths;
    for (const MapStroke& stroke : strokes) {
        middles.push_back(stroke.points[stroke.points.size() / 2]);
        lengths.push_back(length_of(stroke));
    }
    std::vector<double> clearance(count, 1.0);  // distance to the nearest ranked stroke
    std::vector<bool> is_ranked(count, false);
    for (std::size_t rank = 0; rank < count; ++rank) {
        std::size_t best = count;
        for (std::size_t i = 0; i < count; ++i) {
            if (is_ranked[i]) continue;
            if (best == count || clearance[i] * std::sqrt(lengths[i]) > clearance[best] * std::sqrt(lengths[best]))
                best = i;
        }
        is_ranked[best] = true;
        strokes[best].priority = static_cast<double>(rank);
        for (std::size_t i = 0; i < count; ++i)
            clearance[i] = std::min(clearance[i], wrapped_distance(middles[i], middles[best]));
    }
}

}  // namespace hw
