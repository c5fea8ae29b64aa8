#pragma once

#include <map>
#include <string>

#include "hatchway/style/style.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// How one object is drawn. Indices point into the styles and maps that are handed along with it.
struct StyledObject {
    int style = kNone;       ///< kNone: the object is not drawn.
    int over = kNone;        ///< A second style, drawn over the first with `presence`.
    PresenceField presence;  ///< Of `over`; the first style keeps the rest.
    float certainty = 1.0f;
    std::map<MapKind, int> maps;

    bool operator==(const StyledObject&) const = default;
};

/// A prepared style. The owner keeps it alive while anything may draw with it.
struct NamedStyle {
    std::string name;
    Style* style = nullptr;
};

}  // namespace hw
