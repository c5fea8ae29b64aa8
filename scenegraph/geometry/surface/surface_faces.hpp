#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "hatchway/geometry/surface/surface.hpp"

namespace hw {

/// The three corners of a face, in winding order. `face` may be a reversed twin, see FacingFilter.
std::array<std::uint32_t, 3> face_corners(const Surface& surface, std::uint32_t face);

/// The face that gives `face` its plane: itself, or the one it inherits from (FacingFilter::Inherited), or kNoFace.
/// A twin answers with the face that it turns over.
std::uint32_t plane_face(const Surface& surface, std::uint32_t face);

/// The normal of a face's plane as the world shows it, in doubles, any length; zero where it has no plane. A twin's
/// normal is turned over.
glm::dvec3 plane_normal(const Surface& surface, std::uint32_t face);

/// The angle between two normals, in [0, pi]; 0 where one is zero.
float angle_between(const glm::dvec3& a, const glm::dvec3& b);

/// The exact sign of an edge of two faces: -1 strictly convex, 0 flat (or without planes), +1 reflex.
int convexity_sign(const Surface& surface, std::uint32_t face_a, std::uint32_t face_b);

}  // namespace hw
