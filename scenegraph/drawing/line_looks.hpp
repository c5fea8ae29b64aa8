#pragma once

#include <span>
#include <vector>

#include "hatchway/drawing/edge_demand.hpp"
#include "hatchway/style/line_look.hpp"
#include "hatchway/style/view.hpp"
#include "hatchway/world/presence.hpp"

namespace hw {

/// How one of an object's styles draws its lines.
struct ObjectLineLook {
    LineLook look;
    float crease_rad = 0.7f;  ///< Of the style's needs.
    PresenceField field;      ///< The share that the style has in the object.
    bool is_inverted = false;
    double time_s = 0.0;

    /// At a height in the world.
    double presence(double y_m) const
    {
        const double value = presence_at(field, static_cast<float>(y_m), time_s);
        const double share = presence_at(look.share, static_cast<float>(y_m), time_s);
        return (is_inverted ? 1.0 - value : value) * share;
    }
};

/// Which edges an object's styles draw, and how.
struct ObjectPens {
    EdgeDemand edges;
    std::vector<ObjectLineLook> looks;
};

/// Asks every style how it draws the lines of its objects in a view, without drawing: one for each object.
std::vector<ObjectPens> object_pens(const Scene& scene, std::span<const NamedStyle> styles,
                                    std::span<const StyledObject> objects, const View& view);

}  // namespace hw
