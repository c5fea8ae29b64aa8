#pragma once

#include <vector>

#include "hatchway/world/looks.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// Leaves of a scene what its looks show. A hidden object keeps its number, but has an empty mesh and no extent, so
/// that nobody has to ask: it is not drawn, casts no shadow, blocks neither sight nor a walker, has no lines and gets
/// no light. What was hidden before and is not now comes back as it was. While something is hidden, the scene has one
/// mesh more, the empty one, at the end. `looks`: one for each object, or none: then all is shown. Tells whether
/// anything changed.
bool hide_objects(Scene& scene, const std::vector<ObjectLook>& looks);

/// Whether hide_objects() would change anything.
bool would_change(const Scene& scene, const std::vector<ObjectLook>& looks);

/// The objects that are hidden now, in order.
std::vector<ObjectId> hidden_objects(const Scene& scene);

}  // namespace hw
