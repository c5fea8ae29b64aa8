#pragma once

#include <string>
#include <vector>

#include "hatchway/io/json/out.hpp"
#include "hatchway/world/level.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// What the rules of a level can name and what they say, a line for each node with objects: its number and path, the
/// materials of its objects, and how these are drawn.
std::vector<std::string> node_lines(const Level& level, const Scene& scene);

/// The same for programs, an entry for each object: node, path, material, style, over, certainty, is_visible, and which
/// rule decided each, as a JSON pointer into the level or the model; empty where nobody said anything.
JsonValue nodes_json(const Level& level, const Scene& scene);

/// " (2 hidden)", or nothing.
std::string hidden_text(const Scene& scene);

}  // namespace hw
