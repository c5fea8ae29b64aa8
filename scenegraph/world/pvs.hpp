#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace hw {

/// An opening between two leaves, for one direction of sight: a one-sided wall leaves it open one way only.
struct DirectedPortal {
    int from_leaf = 0;
    int to_leaf = 0;
    glm::dvec3 normal{0.0};           ///< Unit, the direction of travel.
    double offset = 0.0;              ///< normal.x + offset is 0 on the portal.
    std::vector<glm::dvec3> winding;  ///< Convex, in order around, either way.
};

/// Convex leaves and the openings between them.
struct PortalGraph {
    int leaf_count = 0;
    std::vector<DirectedPortal> portals;
};

/// One bit for each pair of leaves: does the row's leaf see the other. Every leaf sees itself.
class LeafRows {
 public:
    LeafRows() = default;
    explicit LeafRows(int leaf_count)
        : leaf_count_(leaf_count), words_((static_cast<std::size_t>(leaf_count) + 63) / 64),
          bits_(words_ * static_cast<std::size_t>(leaf_count))
    {
    }
    int leaf_count() const { return leaf_count_; }
    std::span<std::uint64_t> row(int leaf) { return {bits_.data() + words_ * static_cast<std::size_t>(leaf), words_}; }
    std::span<const std::uint64_t> row(int leaf) const
    {
        return {bits_.data() + words_ * static_cast<std::size_t>(leaf), words_};
    }
    bool sees(int from, int to) const
    {
        return (row(from)[static_cast<std::size_t>(to) / 64] >> (to % 64) & 1) != 0;
    }

 private:
    int leaf_count_ = 0;
    std::size_t words_ = 0;
    std::vector<std::uint64_t> bits_;
};

/// How tight the rows are. All are conservative, each is a subset of the one before.
enum class PvsEffort : std::uint8_t {
    fast,   ///< Portals that face each other, flooded: no separating planes.
    full,   ///< Portal flow with separating planes between the first and the last portal.
    exact,  ///< Also clips the first portal as seen from the last ones, and has no budget.
};

struct PvsOptions {
    PvsEffort effort = PvsEffort::full;
    double seconds = 0.0;     ///< Rough time after which portals keep the coarse answer; 0: no limit.
    int threads = 0;          ///< 0: as many as the machine has.
    double slack = 1e-7;      ///< Length by which every clip keeps more than it should.
    double least = 1e-5;      ///< A sight line this narrow at its far portal is tangential and counts as none.
};

struct PvsResult {
    LeafRows rows;
    int coarse_portals = 0;  ///< Those that ran out of time.
};

/// Which leaves can be seen from somewhere in each leaf through the portals. Conservative.
/// Source: Teller, Sequin. Visibility preprocessing for interactive walkthroughs. SIGGRAPH 1991; the flow with separating
/// planes between source and pass portal follows the description of Quake's vis.
PvsResult build_pvs(const PortalGraph& graph, const PvsOptions& options);

}  // namespace hw
