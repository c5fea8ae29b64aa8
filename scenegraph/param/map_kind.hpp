#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace hw {

/// The kinds of maps. kMapKinds says all else that the engine has to know of a kind.
enum class MapKind : unsigned char { hatch, ink, tonal, ramp, image };

struct MapKindFacts {
    std::string_view name;   ///< In level files and map.json. Shaders have hw_NAME_map, hw_NAME_info and HW_NAME_MAP.
    std::string_view help;   ///< One sentence, for the schema of level files.
    bool is_colour = false;  ///< sRGB; else gray and linear: 0 ink, 1 paper.
    bool is_strip = false;   ///< One texel high.
    bool repeats = true;     ///< Beyond its borders; else they go on.
    bool is_lone = false;    ///< Has one level.
};

/// In the order of MapKind. A name in a level is that of a built-in map, or a folder relative to the level file.
inline constexpr std::array<MapKindFacts, 5> kMapKinds{{
    {.name = "hatch",
     .help = "Map of parallel lines: a built-in map, or a folder relative to this file.",
     .is_strip = true},
    {.name = "ink", .help = "Map of drawn detail: a built-in map, or a folder relative to this file."},
    {.name = "tonal", .help = "Map of hatching by tone: a built-in map, or a folder relative to this file."},
    {.name = "ramp",
     .help = "Map of the colours that tones get, from dark to light: a folder relative to this file.",
     .is_colour = true,
     .is_strip = true,
     .repeats = false,
     .is_lone = true},
    {.name = "image", .help = "Picture that lies on the surface: a folder relative to this file.", .is_colour = true},
}};
inline constexpr std::size_t kMapKindCount = kMapKinds.size();

constexpr const MapKindFacts& facts_of(MapKind kind)
{
    return kMapKinds[static_cast<std::size_t>(kind)];
}

}  // namespace hw
