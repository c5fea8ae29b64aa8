#include "hatchway/geometry/exact/viewpoint.hpp"

#include <cmath>
#include <glm/matrix.hpp>

namespace hw {

Viewpoint in_object(const Viewpoint& world, const glm::dmat4& world_from_object)
{
    constexpr double kSmallest = 1e-60;
    const glm::dmat4 object_from_world = glm::inverse(world_from_object);
    glm::dvec3 eye(object_from_world * glm::dvec4(world.eye, world.is_orthographic ? 0.0 : 1.0));
    for (int axis = 0; axis < 3; ++axis) {
        if (!(std::abs(eye[axis]) >= kSmallest) || !std::isfinite(eye[axis])) eye[axis] = 0.0;
    }
    return {eye, world.is_orthographic};
}

}  // namespace hw
