#pragma once

#include <cstdint>

namespace hw {

/// The kinds of lines a drawing has, each with its own width and colour. An edge whose faces disagree about the eye is
/// a silhouette in that view, however folded; ridges, valleys and artist's edges are so where both faces show one side.
enum class LineClass : std::uint8_t { silhouette, ridge, valley, border, artist, intersection };
inline constexpr int kLineClassCount = 6;

inline bool is_crease(LineClass line_class)
{
    return line_class == LineClass::ridge || line_class == LineClass::valley;
}

/// Where the surface ends or turns away from the eye.
inline bool is_contour(LineClass line_class)
{
    return line_class == LineClass::silhouette || line_class == LineClass::border;
}

/// [a-z]+, as drawings and files name it.
constexpr const char* line_class_name(LineClass line_class)
{
    constexpr const char* kNames[kLineClassCount] = {"silhouette", "ridge",  "valley",
                                                     "border",     "artist", "intersection"};
    return kNames[static_cast<int>(line_class)];
}

}  // namespace hw
