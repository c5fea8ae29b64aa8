#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace hw {

/// Where a surface is looked at from: an eye, or for orthographic views the direction from the surface to the viewer.
struct Viewpoint {
    glm::dvec3 eye{0.0};           ///< Position, or direction of any length; finite.
    bool is_orthographic = false;  ///< `eye` is a direction.
};

/// The same viewpoint in the space of an object. This rounded value is *the* eye: every facing decision is exact for
/// it. Components under 1e-60 in magnitude become zero, so that the exact predicates cannot underflow. A matrix that
/// cannot be inverted gives the zero vector: then every face is back-facing or decided from the origin.
Viewpoint in_object(const Viewpoint& world, const glm::dmat4& world_from_object);

}  // namespace hw
