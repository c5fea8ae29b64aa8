#pragma once

#include <cstdint>
#include <functional>
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

/// Leaves and the openings between them. Sight within a leaf is free; a leaf is convex or a union of convex ones.
struct PortalGraph {
    int leaf_count = 0;
    std::vector<DirectedPortal> portals;
};

/// Rows of bits: what each leaf sees.
class LeafRows {
 public:
    LeafRows() = default;
    LeafRows(int leaf_count, int column_count)
        : leaf_count_(leaf_count),
          column_count_(column_count),
          words_((static_cast<std::size_t>(column_count) + 63) / 64),
          bits_(words_ * static_cast<std::size_t>(leaf_count))
    {
    }
    int leaf_count() const { return leaf_count_; }
    int column_count() const { return column_count_; }
    std::span<std::uint64_t> row(int leaf) { return {bits_.data() + words_ * static_cast<std::size_t>(leaf), words_}; }
    std::span<const std::uint64_t> row(int leaf) const
    {
        return {bits_.data() + words_ * static_cast<std::size_t>(leaf), words_};
    }
    bool sees(int leaf, int column) const
    {
        return (row(leaf)[static_cast<std::size_t>(column) / 64] >> (column % 64) & 1) != 0;
    }
    void show(int leaf, int column)
    {
        row(leaf)[static_cast<std::size_t>(column) / 64] |= std::uint64_t{1} << (column % 64);
    }
    void hide(int leaf, int column)
    {
        row(leaf)[static_cast<std::size_t>(column) / 64] &= ~(std::uint64_t{1} << (column % 64));
    }

 private:
    int leaf_count_ = 0;
    int column_count_ = 0;
    std::size_t words_ = 0;
    std::vector<std::uint64_t> bits_;
};

/// Calls visit(column) for each set bit of a row, ascending.
template <typename Visit>
void visit_bits(std::span<const std::uint64_t> words, const Visit& visit)
{
    for (std::size_t word = 0; word < words.size(); ++word) {
        for (std::uint64_t bits = words[word]; bits != 0; bits &= bits - 1) {
            visit(static_cast<int>(word * 64) + __builtin_ctzll(bits));
        }
    }
}

/// How tight the rows are. All are conservative, each is a subset of the one before.
enum class PvsEffort : std::uint8_t {
    fast,   ///< Portals that face each other, flooded: no separating planes.
    full,   ///< Portal flow with separating planes, from the first portal and back from the last, within a budget.
    exact,  ///< The same without a budget.
};

struct PvsOptions {
    PvsEffort effort = PvsEffort::full;
    double seconds = 0.0;  ///< Rough time after which portals keep the coarse answer; 0: no limit.
    int threads = 0;       ///< 0: as many as the machine has.
    double slack = 1e-9;   ///< Length by which every clip keeps more than it should.
    double least = 1e-5;   ///< A sight line this narrow at its far portal is tangential and counts as none.
    std::function<void(double share)> progress;  ///< Told how much is done, 0 to 1; may be empty.
};

struct PvsResult {
    LeafRows rows;                    ///< Leaves by leaves; every leaf sees itself.
    std::vector<int> coarse_portals;  ///< Those that ran out of time.
};

/// Which leaves can be seen from somewhere in each leaf through the portals. Conservative.
/// Source: Teller, Sequin. Visibility preprocessing for interactive walkthroughs. SIGGRAPH 1991; the flow with
/// separating planes between source and pass portal follows the description of Quake's vis.
PvsResult build_pvs(const PortalGraph& graph, const PvsOptions& options);

}  // namespace hw
