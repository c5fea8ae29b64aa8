#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>

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

/// The kinds of maps that a parameter may name.
enum class MapKind : unsigned char { hatch, ink, tonal, ramp, image };

/// A named map as a parameter holds it: the name of a built-in map, or a path relative to the level file. Empty: none.
struct MapName {
    std::string value;
    bool operator==(const MapName&) const = default;
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
    /// `value` is an index into `names`.
    virtual void choice(const ParamInfo& info, int& value, std::span<const std::string_view> names) = 0;
    virtual void map(const ParamInfo& info, MapName& value, MapKind kind) = 0;
};

}  // namespace hw
