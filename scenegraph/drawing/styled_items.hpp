#pragma once

#include "hatchway/drawing/styled_object.hpp"

namespace hw {

/// What a style sees of an object that it draws: `is_over`, as the object's second style. `slot` is the caller's own.
DrawItem item_of(const Scene& scene, ObjectId id, const StyledObject& look, bool is_over, std::uint32_t slot = 0);

}  // namespace hw
