#pragma once

#include <glm/vec3.hpp>

#include "hatchway/geometry/exact/viewpoint.hpp"

namespace hw {

/// The exact sign of the determinant (b - a) x (c - a) . (d - a): +1 when d lies on the side of the plane abc from
/// which a, b, c turn counter-clockwise, -1 on the other side, 0 when the four points are coplanar. Coordinates: 0 or
/// of magnitude in [1e-60, 1e60]. Source: Shewchuk. Adaptive Precision Floating-Point Arithmetic and Fast Robust
/// Geometric Predicates. 1997.
int orient3d_sign(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);

/// The exact sign of (b - a) x (c - a) . direction, same conditions.
int direction_sign(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& direction);

/// Which stage decided a predicate.
enum class PredicateStage : unsigned char { filter, exact };

/// The exact sign of a face's facing: +1 looks at the viewer, -1 looks away, 0 contains the eye in its plane or has no
/// plane. Only +1 is front-facing. `stage`, when given, tells whether doubles were enough.
int facing_sign(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const Viewpoint& viewpoint_object,
                PredicateStage* stage = nullptr);

/// Whether the three points lie on one line, exactly.
bool are_collinear(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

}  // namespace hw
