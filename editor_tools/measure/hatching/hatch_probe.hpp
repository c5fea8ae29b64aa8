#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "hatchway/core/pixels.hpp"
#include "hatchway/maps/map_levels.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

class Context;
class Style;

/// The ways of choosing a hatch map's level that are compared.
enum class LevelChoice : unsigned char { ours, trilinear, anisotropic, ordinary_mips, no_mips };
inline constexpr std::array<std::string_view, 5> kLevelChoices{"ours", "trilinear", "anisotropic", "ordinary mips",
                                                               "no mips"};

/// Where hatching is looked at.
struct HatchPlace {
    bool is_sphere = false;
    double angle_deg = 0.0;  ///< Between the plane's normal and the view; a sphere has all angles.
    double distance = 1.0;   ///< 1: a texel of the map's finest level covers a pixel where it is seen straight on.
};

/// A picture of a hatched surface alone, lines level, and what it cost.
struct HatchPicture {
    Pixels pixels;
    double surfaces_ms = 0.0;
};

/// Draws a plane or a sphere with the engine's own hatch map and shader, at 1 sample.
class HatchProbe {
 public:
    /// Throws hw::Error. The context must be current in every call and outlive the probe.
    explicit HatchProbe(Context& context);
    ~HatchProbe();

    HatchPicture draw(const HatchPlace& place, LevelChoice choice, glm::ivec2 size_px, double fov_deg);

 private:
    struct State;
    std::unique_ptr<State> state_;
};

/// A style that shows a hatch map alone, its level chosen in one way, not yet prepared.
std::unique_ptr<Style> make_probe_style(LevelChoice choice);

/// The map's finest level with ordinary mips under it.
MapLevels ordinary_levels(const MapLevels& map);

/// Linear ink coverage of a column of the picture, from top to bottom.
std::vector<double> column_ink(const Pixels& picture, int x);

}  // namespace hw
