#include "hatchway/maps/hatch_map.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

/// The length of [a, b] that lies in a line: lines are centred on the multiples of `spacing`.
double inked(double a, double b, double spacing, double line)
{
    double length = 0.0;
    for (double middle = std::floor(a / spacing) * spacing; middle <= b + spacing; middle += spacing)
        length += std::max(0.0, std::min(b, middle + 0.5 * line) - std::max(a, middle - 0.5 * line));
    return length;
}

Pixels drawn_level(int width, double spacing, double line)
{
    Pixels level{.width = width, .height = 1, .channels = 1};
    for (int x = 0; x < width; ++x) {
        // Lines lie on the borders between texels 0 and -1, so that the border of a coarser level is one of a finer
        // level.
        const double ink = width >= spacing ? inked(x, x + 1.0, spacing, line) : line / spacing;
        level.bytes.push_back(static_cast<std::uint8_t>(std::lround(255.0 * (1.0 - std::clamp(ink, 0.0, 1.0)))));
    }
    return level;
}

}  // namespace

MapLevels make_hatch_map(const HatchMapDesc& desc)
{
    HW_ASSERT(desc.width_texels > 0 && std::has_single_bit(static_cast<unsigned>(desc.width_texels)));
    HW_ASSERT(desc.spacing_texels > 0 && std::has_single_bit(static_cast<unsigned>(desc.spacing_texels)));
    HW_ASSERT(desc.line_texels >= 0.0 && desc.line_texels <= desc.spacing_texels);
    MapLevels map{.kind = MapKind::hatch,
                  .size_m = desc.width_texels / 1024.0,
                  .spacing_texels = static_cast<double>(desc.spacing_texels)};
    for (int width = desc.width_texels; width >= 1; width /= 2)
        map.levels.push_back(drawn_level(width, desc.spacing_texels, desc.line_texels));
    return map;
}

}  // namespace hw
