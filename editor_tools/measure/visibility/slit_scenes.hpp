#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "hatchway/world/scene.hpp"
#include "hatchway/world/visibility/visibility.hpp"

namespace hw::measure {

/// A small closed scene with an eye and an object of which it is known by construction whether the eye's room sees it.
struct SlitScene {
    std::string name;
    Scene scene;
    glm::dvec3 eye{0.0};
    ObjectId target = 0;
    bool is_seen = false;
};

/// Rooms behind walls with slits from 1 to 0.001 m, two slits in a row, walls that are closed, half high or one-sided.
std::vector<SlitScene> slit_scenes();

/// Whether the ray from the eye to the middle of the target reaches it, by rational arithmetic on the drawn triangles:
/// the second witness of `is_seen` where that is true.
bool is_target_met(const SlitScene& slit);

/// Whether the eye's place has a row at all: inside of a wall, as which the back of a one-sided one counts, all is
/// shown.
bool reads_row(const SlitScene& slit, const Visibility& visibility);

/// What a visibility says: whether the target is drawn for the eye.
bool is_target_shown(const SlitScene& slit, const Visibility& visibility);

}  // namespace hw::measure
