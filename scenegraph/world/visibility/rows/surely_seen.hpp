#pragma once

#include "hatchway/world/visibility/rows/flow_graph.hpp"

namespace hw {

/// Leaves that straight lines through the source portal reach, found by walking random ones (always the same): each is
/// seen for certain, so the flow need not prove it.
LeafBits surely_seen(const FlowGraph& graph, const FlowPortal& source);

}  // namespace hw
