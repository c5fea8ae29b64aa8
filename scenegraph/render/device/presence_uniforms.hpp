#pragma once

#include "hatchway/style/draw_item.hpp"

namespace hw {

/// Whether an item's presence is other than 1 everywhere.
bool has_presence(const DrawItem& item);
/// False where the item shows nothing anywhere at this time.
bool shows_at_all(const DrawItem& item, double time_s);
/// Sets the uniforms of shaders/presence.glsl.
void set_presence(int height_location, int inverted_location, const DrawItem& item, double time_s);

}  // namespace hw
