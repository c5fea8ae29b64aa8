#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace hw {

/// Numbers from 0 on in sets that get joined. A set is named by its smallest number, in whatever order it was joined.
class DisjointSets {
 public:
    explicit DisjointSets(std::size_t count = 0) : root_(count) { std::iota(root_.begin(), root_.end(), 0u); }

    std::uint32_t size() const { return static_cast<std::uint32_t>(root_.size()); }
    /// Adds the next number, alone in its set.
    void add() { root_.push_back(size()); }
    /// The set of a number.
    std::uint32_t of(std::uint32_t i)
    {
        while (root_[i] != i) i = root_[i] = root_[root_[i]];
        return i;
    }
    /// Returns the joined set.
    std::uint32_t join(std::uint32_t a, std::uint32_t b)
    {
        a = of(a);
        b = of(b);
        return root_[std::max(a, b)] = std::min(a, b);
    }

 private:
    std::vector<std::uint32_t> root_;
};

}  // namespace hw
