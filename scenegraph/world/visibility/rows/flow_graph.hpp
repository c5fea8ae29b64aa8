#pragma once

#include <cstdint>
#include <vector>

#include "hatchway/world/visibility/rows/pvs.hpp"
#include "hatchway/world/visibility/tree/portal_polygon.hpp"

namespace hw {

/// A set of leaves as bits.
using LeafBits = std::vector<std::uint64_t>;

inline void set_bit(LeafBits& bits, int leaf)
{
    bits[static_cast<std::size_t>(leaf) / 64] |= std::uint64_t{1} << (leaf % 64);
}

inline bool has_bit(const LeafBits& bits, int leaf)
{
    return (bits[static_cast<std::size_t>(leaf) / 64] >> (leaf % 64) & 1) != 0;
}

inline int bit_count(const LeafBits& bits)
{
    int count = 0;
    for (const std::uint64_t word : bits) count += __builtin_popcountll(word);
    return count;
}

/// A portal while the PVS is made.
struct FlowPortal {
    int to_leaf = 0;
    FlowPlane plane;
    glm::dvec3 centre{0.0};  ///< In the winding, and of a ball around it.
    double radius = 0.0;
    LeafBits sees;          ///< At most these leaves: coarse first, then what the flow finds.
    LeafBits surely;        ///< At least these.
    bool is_coarse = true;  ///< The flow has not finished, if it has begun.
    Winding winding;        ///< Last: it is large, and most portals are told by what comes before.
};

/// A PortalGraph made ready for the flow.
struct FlowGraph {
    int leaf_count = 0;
    std::vector<FlowPortal> portals;
    std::vector<std::vector<int>> portals_out_of;  ///< By leaf.
    ClipTolerance tolerance;
};

}  // namespace hw
