#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hatchway/world/light/transport.hpp"

namespace hw {

/// A scene whose light is known.
struct LightCase {
    std::string name;
    Scene scene;
    LightSources sources;
    double luxels_per_m = 8.0;
    ObjectId measured = 0;  ///< The object whose light is compared.
    /// Lux at a place, not finite where nobody looks; empty: compared with the same bake of many more samples.
    std::function<double(const glm::dvec3& place_world, const glm::dvec3& normal_world)> reference;
};

/// Point, sun, rectangle, covered sky, a wall that stands on the floor (and its foot alone) and closed bright room,
/// each with its closed form; and a lit room without one.
std::vector<LightCase> light_cases();
/// The one of that name, which there must be.
const LightCase& light_case_named(const std::string& name);

/// A room that is closed and dark within, in bright surroundings.
struct DarkRoom {
    std::string name;
    Scene scene;
    LightSources sources;
    glm::dmat4 room_from_world{1.0};
    Box inside;  ///< Of the room's own space: what it encloses.
};

/// Rooms with walls of 0.05 m: of slabs, as a shell, and walls that stand on a floor which goes on outside; each
/// straight and turned by an odd angle.
std::vector<DarkRoom> dark_rooms();

// Building blocks, also of tests.
int add_material(Scene& scene, float albedo, float emission = 0.0f);
/// A parallelogram from a corner along two sides; its front is cross(u, v).
ObjectId add_quad(Scene& scene, int material, const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v);
/// An axis-parallel box, moved by `world_from_box`; its fronts look outwards, or inwards.
ObjectId add_box(Scene& scene, int material, const Box& box, const glm::dmat4& world_from_box = glm::dmat4(1.0),
                 bool is_inward = false);

}  // namespace hw
