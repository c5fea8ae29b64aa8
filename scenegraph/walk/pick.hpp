#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "hatchway/world/collision/collision.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// The drawn triangles of a scene, ready to be asked what a ray meets. The scene must live as long.
struct PickWorld {
    const Scene* scene = nullptr;
    CollisionWorld still;  ///< Everything that does not move.
    std::vector<CollisionWorld::Triangle> moving;
    std::vector<char> is_mirrored;  ///< For each object: its transform turns front faces to back faces.
};

struct PickHit {
    ObjectId object = 0;
    double distance_m = 0.0;
};

PickWorld build_pick_world(const Scene& scene);

/// The nearest triangle that the ray meets from a side from which it is drawn: single-sided ones from their front only.
/// `direction` is a unit vector. Method: Möller and Trumbore. Fast, minimum storage ray/triangle intersection. 1997.
std::optional<PickHit> pick(const PickWorld& world, const glm::dvec3& eye_world, const glm::dvec3& direction);

}  // namespace hw
