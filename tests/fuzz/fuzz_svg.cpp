// Drawings that become ink maps.
#include "hatchway/io/drawings/svg_strokes.hpp"
#include "hatchway/maps/ink_map.hpp"
#include "tests/fuzz/target.hpp"

void hw::fuzz::try_bytes(std::string_view bytes)
{
    const SvgDrawing drawing = parse_svg_strokes(std::string(bytes), "fuzz.svg");
    std::vector<MapStroke> strokes;
    for (const SvgStroke& stroke : drawing.strokes)
        strokes.push_back({.points = stroke.points, .width = stroke.width, .priority = stroke.priority});
    rank_evenly(strokes);
    const InkMap map = make_ink_map(strokes, {.width_texels = 32, .height_texels = 32});
    require(!map.map.levels.empty() && map.stroke_counts.size() == map.map.levels.size());
}
