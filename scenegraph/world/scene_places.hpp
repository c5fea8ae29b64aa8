#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hatchway/core/box.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// Where the geometry of a scene lies. Most scenes lie together; a stray object, a point of a georeferenced model that
/// was left at the origin, or a ground without end does not, and takes nothing of what the others need.
struct ScenePlaces {
    /// One for each object that is drawn; where a mesh has parts that lie far apart, or are of very different size, one
    /// for each. Together they hold all of the scene.
    std::vector<Box> boxes_world;
    std::vector<double> triangles;  ///< In each of the boxes.
    Box bounds_world;               ///< Of all.
    /// What lies together, with three quarters of all triangles or more. Empty where nothing is drawn.
    Box main_world;
    /// Objects that are far away from the main place, or have a part there; each once, in their order.
    std::vector<ObjectId> strays;
};

ScenePlaces find_places(const Scene& scene);

/// What lies together where the eye is, with a fiftieth of all triangles or more; all where nothing lies far away.
Box place_around(const ScenePlaces& places, const glm::dvec3& eye_world);

/// What a user should know of strays, with the path of the first; nothing where there is none.
std::optional<std::string> stray_doubt(const ScenePlaces& places, const Scene& scene);

/// The end of the group of values that begins at the least one above `from`: no value of it is more than `factor` times
/// as large as one before it. `from` where none is above it. Values from 0 on, in any order.
double end_of_group(std::span<const double> values, double from, double factor);

/// From a point to the farthest one of a box.
double farthest(const Box& box, const glm::dvec3& point);

}  // namespace hw
