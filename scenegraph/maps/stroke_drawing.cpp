#include "hatchway/maps/stroke_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

constexpr std::size_t kMostRankSteps = 400'000'000;  // 20,000 strokes, each against each

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

struct Span {
    double from = 0.0;
    double to = 0.0;
};

/// Where on a row of texels, whose middles lie at `y`, the segment may leave ink.
Span inked_span(const glm::dvec2& a, const glm::dvec2& b, double y, double reach)
{
    const double slope = (b.x - a.x) / (b.y - a.y);
    const double low = std::min(a.y, b.y);
    const double high = std::max(a.y, b.y);
    const double first = a.x + (std::clamp(y - reach, low, high) - a.y) * slope;
    const double last = a.x + (std::clamp(y + reach, low, high) - a.y) * slope;
    if (!std::isfinite(slope)) return {std::min(a.x, b.x) - reach, std::max(a.x, b.x) + reach};
    return {std::min(first, last) - reach, std::max(first, last) + reach};
}

/// Segment in texels. The pen's edge is a ramp one texel wide, at full ink no higher than the pen is wide. Returns the
/// ink that it added.
double draw_segment(InkPlane& plane, const glm::dvec2& a, const glm::dvec2& b, double width)
{
    const double reach = 0.5 * width + 0.5;
    const int y0 = static_cast<int>(std::floor(std::min(a.y, b.y) - reach));
    const int y1 = static_cast<int>(std::ceil(std::max(a.y, b.y) + reach));
    double added = 0.0;
    for (int y = y0; y <= y1; ++y) {
        const Span span = inked_span(a, b, y + 0.5, reach);
        const int x0 = static_cast<int>(std::floor(span.from)) - 1;
        const int x1 = static_cast<int>(std::ceil(span.to));
        for (int x = x0; x <= x1; ++x) {
            const double distance = distance_to_segment(glm::dvec2(x + 0.5, y + 0.5), a, b);
            const float ink = static_cast<float>(std::clamp(reach - distance, 0.0, std::min(width, 1.0)));
            float& texel = plane.at(wrapped(x, plane.width), wrapped(y, plane.height));
            if (ink <= texel) continue;
            added += static_cast<double>(ink) - texel;
            texel = ink;
        }
    }
    return added;
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

double draw_stroke(InkPlane& plane, const MapStroke& stroke, double width_texels)
{
    HW_ASSERT(!stroke.points.empty());
    const glm::dvec2 size(plane.width, plane.height);
    const double width = width_texels * stroke.width;
    const std::size_t count = stroke.points.size();
    double added = 0.0;
    for (std::size_t i = 0; i + 1 < std::max<std::size_t>(count, 2); ++i)
        added += draw_segment(plane, stroke.points[i] * size, stroke.points[std::min(i + 1, count - 1)] * size, width);
    return added;
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
    std::vector<double> weights;
    for (const MapStroke& stroke : strokes) {
        middles.push_back(stroke.points[stroke.points.size() / 2]);
        weights.push_back(std::sqrt(length_of(stroke)));
    }
    std::vector<double> clearance(count, 1.0);  // distance to the nearest ranked stroke
    const auto merit = [&](std::size_t i) { return clearance[i] * weights[i]; };
    std::vector<std::size_t> unranked(count);
    std::iota(unranked.begin(), unranked.end(), std::size_t{0});
    const std::size_t rounds = std::min(count, kMostRankSteps / std::max<std::size_t>(count, 1));
    std::size_t rank = 0;
    for (; rank < rounds; ++rank) {
        const auto best = std::ranges::max_element(unranked, {}, merit);
        const glm::dvec2 middle = middles[*best];
        strokes[*best].priority = static_cast<double>(rank);
        unranked.erase(best);
        for (const std::size_t i : unranked)
            clearance[i] = std::min(clearance[i], wrapped_distance(middles[i], middle));
    }
    std::ranges::stable_sort(unranked, std::ranges::greater(), merit);
    for (const std::size_t i : unranked) strokes[i].priority = static_cast<double>(rank++);
}

}  // namespace hw
