#pragma once

#include <vector>

#include "hatchway/walk/player.hpp"
#include "hatchway/world/level.hpp"
#include "measure/walk/walk_fuzz.hpp"

namespace hw::measure {

/// The level's start, its and its model's cameras, and path keys: those from which a walker stands.
std::vector<PlayerState> named_places(const Level& level, const Scene& scene, const PlayerBody& body,
                                      const CollisionWorld& world);

/// Places all over the scene that the oracle chooses: those where a walker stands. The same ones every time.
std::vector<PlayerState> scattered_places(const WalkOracle& oracle, const PlayerBody& body,
                                          const CollisionWorld& world);

/// Where feet get on foot from some places, the places included: one state for each cell of `cell_m` in which a walker
/// stands, in the order in which a search reaches them that walks in eight directions from each. At most `most`.
std::vector<PlayerState> places_on_foot(const Walker& walker, std::span<const PlayerState> starts, double cell_m,
                                        std::size_t most);

}  // namespace hw::measure
