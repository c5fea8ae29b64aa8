#pragma once

#include <string>
#include <vector>

#include "hatchway/core/budget.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// A name of nodes in a level file and where it stands there.
struct NodeName {
    std::string nodes;    ///< A path glob, or "#12": a node by index.
    std::string file;     ///< Of the level, for messages.
    std::string pointer;  ///< JSON pointer of the name.
};

/// Marks, for every node, whether it or one of its parents is named; `marks` has one for each node. Throws hw::Error
/// for a name that reaches no node, and where the budget runs out.
void mark_named_nodes(const Scene& scene, const NodeName& name, Budget& budget, std::vector<char>& marks);

}  // namespace hw
