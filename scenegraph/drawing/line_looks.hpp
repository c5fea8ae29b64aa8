#pragma once

#include <vector>

#include "hatchway/plugin_host/plugin_registry.hpp"
#include "hatchway/style/line_look.hpp"
#include "hatchway/style/view.hpp"
#include "hatchway/world/level.hpp"
#include "hatchway/world/presence.hpp"

namespace hw {

/// How one of an object's styles draws its lines.
struct ObjectLineLook {
    LineLook look;
    PresenceField field;  ///< The share that the style has in the object.
    bool is_inverted = false;
    double time_s = 0.0;

    /// At a height in the world.
    double presence(double y_m) const
    {
        const double value = presence_at(field, static_cast<float>(y_m), time_s);
        return is_inverted ? 1.0 - value : value;
    }
};

/// What the styles of an object make of its edges.
struct ObjectInk {
    bool is_used = false;            ///< A style of the object draws edges.
    float crease_rad = 0.0f;         ///< The smallest that its styles ask for.
    bool has_intersections = false;  ///< A style draws where the object goes through others.
    std::uint32_t style_group = 0;   ///< Objects of one group hide each other's seams.
    std::vector<ObjectLineLook> looks;
};

/// Asks the styles of a level how they draw the lines of each object. They are prepared as for drawing, but no device
/// is needed: shaders are not compiled. Throws hw::Error for a wrong style.
std::vector<ObjectInk> object_inks(const Level& level, const Scene& scene, const PluginRegistry& registry,
                                   const View& view);

}  // namespace hw
