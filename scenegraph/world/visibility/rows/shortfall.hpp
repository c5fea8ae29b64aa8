#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <string>

#include "hatchway/core/box.hpp"

namespace hw {

/// Where a level was too fine for a budget of the compiler. More is visible for it, never less.
struct Shortfall {
    std::string what;  ///< A sentence with the counts and the budget.
    Box where_world;   ///< The part of the scene where it is worst.
};

/// The cell of an 8 x 8 x 8 grid over `bounds` with the most of the places; of equals the first. `bounds` where there
/// are none.
Box densest_part(std::span<const glm::dvec3> places, const Box& bounds);

/// In one line: what, and from where to where, in metres.
std::string shortfall_text(const Shortfall& shortfall);

}  // namespace hw
