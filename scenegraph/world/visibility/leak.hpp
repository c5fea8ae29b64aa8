#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "hatchway/world/level.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// A place that a sealed level means to be inside.
struct InsidePlace {
    std::string name;
    glm::dvec3 position_world{0.0};
};

/// A way by which sight gets out of a sealed level.
struct Leak {
    std::string from;                      ///< The inside place.
    std::vector<glm::dvec3> points_world;  ///< From it through openings to the outside; at least one.
    glm::dvec3 opening_world{0.0};         ///< Middle of the narrowest opening on the way: likely the hole.
    double opening_m2 = 0.0;
    std::string near_node;  ///< Path of the node closest to it.
};

/// The inside places of a level: its start, else its cameras, else the keys of its paths.
std::vector<InsidePlace> inside_places(const Level& level);

/// Where sight gets from an inside place out of the level, each a hole of its own, the widest first.
struct LeakSearch {
    std::vector<Leak> leaks;  ///< None: the level is sealed.
    /// False: the level is too fine for the search's budget. What was left out is taken to be open, so that a leak may
    /// be none.
    bool is_complete = true;
};

/// Searches for at most `most` leaks.
///
/// All that is opaque, static and drawn blocks, from the sides from which it is drawn; glass, foliage and animated
/// doors do not. Openings narrower than kCrackWidth are closed. Method: the scene's polygons split a box that is larger
/// than the scene; leaves are joined by what is open between them; a leaf at the face of the box is outside; the way
/// whose narrowest opening is widest is found, and of those the shortest. Throws what choose_structure() throws.
LeakSearch find_leaks(const Scene& scene, const Level& level, std::span<const InsidePlace> places, int most = 8);

}  // namespace hw
