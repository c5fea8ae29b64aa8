#pragma once

#include "hatchway/world/level.hpp"

namespace hw {

/// Gives each style that is like another the plugin of that one, and the parameters that it does not state itself; they
/// keep their places for messages. That one may be like a third, and so on, a few steps. Throws hw::Error for a style
/// that does not exist, for a circle and for a chain that is longer. Private to io.
void inherit_styles(Level& level);

}  // namespace hw
