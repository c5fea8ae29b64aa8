#pragma once

#include <glm/vec4.hpp>

#include "hatchway/drawing/frame_items.hpp"

namespace hw {

/// Whether a field is other than 1 somewhere.
bool varies(const PresenceField& field);
/// The argument of hw_share_at() in shaders/presence.glsl.
glm::vec4 share_uniform(const PresenceField& field, double time_s);

/// Whether an item's presence is other than 1 everywhere.
bool has_presence(const DrawItem& item);
/// False where the item shows nothing anywhere at this time.
bool shows_at_all(const DrawItem& item, double time_s);
/// Sets the uniforms of shaders/presence.glsl.
void set_presence(int height_location, int inverted_location, const DrawItem& item, double time_s);

}  // namespace hw
