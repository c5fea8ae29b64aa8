// Drawings that become ink maps. What is taken keeps to the limits of read_svg_strokes(): whoever draws it relies on
// them.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "hatchway/io/drawings/svg_strokes.hpp"
#include "hatchway/maps/ink_map.hpp"
#include "tests/fuzz/target.hpp"

namespace {

using hw::fuzz::require;

void require_limits(const hw::SvgDrawing& drawing)
{
    require(drawing.height_share >= 1.0 / 256.0 && drawing.height_share <= 256.0);
    require(!drawing.strokes.empty() && drawing.strokes.size() <= 100'000);
    std::size_t points = 0;
    double ink = 0.0;
    for (const hw::SvgStroke& stroke : drawing.strokes) {
        require(!stroke.points.empty() && stroke.width > 0.0 && std::isfinite(stroke.width + stroke.priority));
        points += stroke.points.size();
        for (std::size_t i = 0; i < stroke.points.size(); ++i) {
            const glm::dvec2& point = stroke.points[i];
            require(std::abs(point.x) <= 1e5 && std::abs(point.y) <= 1e5);
            if (i > 0) ink += glm::distance(stroke.points[i - 1], point);
        }
    }
    require(points <= 200'000 && ink <= 4000.0);
}

}  // namespace

void hw::fuzz::try_bytes(std::string_view bytes)
{
    const SvgDrawing drawing = parse_svg_strokes(std::string(bytes), "fuzz.svg");
    require_limits(drawing);
    std::vector<MapStroke> strokes;
    for (const SvgStroke& stroke : drawing.strokes)
        strokes.push_back({.points = stroke.points, .width = stroke.width, .priority = stroke.priority});
    rank_evenly(strokes);
    const InkMap map = make_ink_map(strokes, {.width_texels = 32, .height_texels = 32});
    require(!map.map.levels.empty() && map.stroke_counts.size() == map.map.levels.size());
}
