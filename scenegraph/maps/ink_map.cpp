#include "hatchway/maps/ink_map.hpp"

#include <algorithm>
#include <cmath>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

struct DrawnLevel {
    InkPlane plane;
    std::size_t stroke_count;
};

/// How many strokes in order bring the tone nearest to `tone`.
std::size_t count_to_tone(std::span<const MapStroke> strokes, int width, int height, double pen_texels, double tone)
{
    InkPlane plane(width, height);
    double ink = 0.0;
    double reached = 0.0;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        ink += draw_stroke(plane, strokes[i], pen_texels);
        const double next_tone = ink / static_cast<double>(plane.ink.size());
        if (std::abs(next_tone - tone) > std::abs(reached - tone)) return i;
        reached = next_tone;
    }
    return strokes.size();
}

DrawnLevel drawn_to_tone(std::span<const MapStroke> strokes, int width, int height, double pen_texels, double tone)
{
    DrawnLevel level{InkPlane(width, height), count_to_tone(strokes, width, height, pen_texels, tone)};
    for (const MapStroke& stroke : strokes.first(level.stroke_count)) draw_stroke(level.plane, stroke, pen_texels);
    return level;
}

template <typename Reduce>
MapLevels filtered(const Pixels& finest, double size_m, Reduce reduce)
{
    HW_ASSERT(finest.channels == 1 && !finest.is_empty());
    MapLevels map{.kind = MapKind::ink, .levels = {finest}, .size_m = size_m};
    while (map.levels.back().width > 1 || map.levels.back().height > 1) {
        const Pixels& from = map.levels.back();
        Pixels level{.width = std::max(from.width / 2, 1), .height = std::max(from.height / 2, 1), .channels = 1};
        for (int y = 0; y < level.height; ++y) {
            for (int x = 0; x < level.width; ++x) {
                const int x1 = std::min(2 * x + 1, from.width - 1);
                const int y1 = std::min(2 * y + 1, from.height - 1);
                level.bytes.push_back(
                    reduce(*from.at(2 * x, 2 * y), *from.at(x1, 2 * y), *from.at(2 * x, y1), *from.at(x1, y1)));
            }
        }
        map.levels.push_back(std::move(level));
    }
    return map;
}

}  // namespace

InkMap make_ink_map(std::span<const MapStroke> strokes, const InkMapDesc& desc)
{
    HW_ASSERT(desc.width_texels >= 1 && desc.height_texels >= 1 && desc.pen_texels > 0.0);
    InkMap result;
    result.map.kind = MapKind::ink;
    result.map.size_m = desc.size_m;
    std::vector<MapStroke> sorted = by_priority(strokes);
    double tone = 0.0;
    for (int width = desc.width_texels, height = desc.height_texels;;
         width = std::max(width / 2, 1), height = std::max(height / 2, 1)) {
        const bool is_finest = result.map.levels.empty();
        DrawnLevel level = is_finest || width >= desc.smallest_texels
                               ? drawn_to_tone(sorted, width, height, desc.pen_texels, is_finest ? 1.0 : tone)
                               : DrawnLevel{InkPlane(width, height), 0};
        if (is_finest) tone = mean_ink(level.plane);
        if (level.stroke_count == 0) std::ranges::fill(level.plane.ink, static_cast<float>(tone));
        sorted.resize(std::min(sorted.size(), level.stroke_count));
        result.map.levels.push_back(level_of(level.plane));
        result.stroke_counts.push_back(level.stroke_count);
        if (width == 1 && height == 1) return result;
    }
}

MapLevels filtered_by_mean(const Pixels& finest, double size_m)
{
    return filtered(finest, size_m,
                    [](int a, int b, int c, int d) { return static_cast<std::uint8_t>((a + b + c + d + 2) / 4); });
}

MapLevels filtered_by_minimum(const Pixels& finest, double size_m)
{
    return filtered(finest, size_m, [](int a, int b, int c, int d) {
        return static_cast<std::uint8_t>(std::min({a, b, c, d}));
    });
}

}  // namespace hw
