#pragma once

#include <array>
#include <string_view>

namespace hw {

/// A key of an object in a level file. Private to io.
struct LevelKey {
    std::string_view name;
    std::string_view help;  ///< One sentence, for the schema.
    bool is_required = false;
};

struct LevelRange {
    double min = 0.0;
    double max = 0.0;
};

inline constexpr std::string_view kLevelFormat = "hatchway-level/1";
inline constexpr std::array<std::string_view, 3> kLightTypes{"sun", "point", "spot"};  // as enum LightType
inline constexpr std::array<std::string_view, 3> kMapKinds{"hatch", "ink", "tonal"};
inline constexpr LevelRange kMetres{-1e9, 1e9};
inline constexpr LevelRange kSeconds{0.0, 1e6};
inline constexpr LevelRange kFraction{0.0, 1.0};
inline constexpr LevelRange kFieldOfView{1.0, 170.0};

}  // namespace hw
