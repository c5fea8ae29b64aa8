#pragma once

#include "hatchway/maps/map_levels.hpp"

namespace hw {

/// One picture of a map: above, every level as it is, side by side; below, a plane in perspective that the map covers,
/// as pen_and_ink draws it. Throws hw::Error when there is no device to draw the plane with, or no such style.
Pixels map_preview(const MapLevels& map);

}  // namespace hw
