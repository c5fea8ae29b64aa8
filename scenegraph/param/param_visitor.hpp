#pragma once

#include <cmath>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "hatchway/param/map_kind.hpp"

namespace hw {

/// What happens when a parameter changes while the program runs.
enum class ParamChange : unsigned char {
    live,     ///< A uniform: the next frame shows it.
    rebuild,  ///< Needs, shaders or maps depend on it: a fresh instance is prepared.
};

/// What every parameter says of itself. `name` is lower_snake_case and ends in its unit: width_px, crease_deg.
struct ParamInfo {
    std::string_view name;
    std::string_view help;  ///< One sentence for the manual, the editor and the JSON schema.
    ParamChange change = ParamChange::live;
};

/// A named map as a parameter holds it: the name of a built-in map, or a path relative to the level file. Empty: none.
struct MapName {
    std::string value;
    bool operator==(const MapName&) const = default;
};

/// An image file as a parameter holds it. A style states one of its own folder, such as "grain.png"; a level names one
/// relative to the level file, and the reader makes that an absolute path inside of the level's project. Empty: none.
struct ImageFile {
    std::string value;
    bool operator==(const ImageFile&) const = default;
};

/// Visits a list of parameters, each with its range, unit, help and present value. The level reader, the editor's
/// panel, the JSON schema and the manual are visitors over this one list.
class ParamVisitor {
 public:
    virtual ~ParamVisitor() = default;

    virtual void real(const ParamInfo& info, float& value, float min, float max) = 0;
    virtual void whole(const ParamInfo& info, int& value, int min, int max) = 0;
    virtual void flag(const ParamInfo& info, bool& value) = 0;
    /// An sRGB colour, each channel in [0, 1]; written "#rrggbb" in files.
    virtual void colour(const ParamInfo& info, glm::vec3& value) = 0;
    virtual void map(const ParamInfo& info, MapName& value, MapKind kind) = 0;
    virtual void image(const ParamInfo& info, ImageFile& value) = 0;

    /// One value of an enum that counts from 0; `names` in its order.
    template <typename Enum>
    requires std::is_enum_v<Enum>
    void choice(const ParamInfo& info, Enum& value, std::span<const std::string_view> names)
    {
        int index = static_cast<int>(value);
        choice_of(info, index, names);
        value = static_cast<Enum>(index);
    }

    /// An angle, held in radians and stated in degrees: `info.name` ends in _deg.
    void angle(const ParamInfo& info, float& rad, float min_deg, float max_deg)
    {
        const float before_deg = std::round(glm::degrees(rad) * 1e4f) / 1e4f;  // 40, not 40.000004
        float deg = before_deg;
        real(info, deg, min_deg, max_deg);
        if (deg != before_deg) rad = glm::radians(deg);
    }

 private:
    virtual void choice_of(const ParamInfo& info, int& index, std::span<const std::string_view> names) = 0;
};

}  // namespace hw
