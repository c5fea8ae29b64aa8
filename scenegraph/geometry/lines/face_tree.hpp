#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "hatchway/core/box.hpp"

namespace hw {

/// Boxes in a tree, to find those that meet a box without looking at all.
class FaceTree {
 public:
    explicit FaceTree(std::vector<Box> boxes);

    /// Finds `some` of the boxes only.
    FaceTree(std::vector<Box> boxes, std::vector<std::uint32_t> some);

    const std::vector<Box>& boxes() const { return boxes_; }

    /// Appends the numbers of the boxes that meet `box`, in no order; about `most` where there are more. Returns the
    /// work of it: one for each box found, and for four looked at, which are many where boxes are long and cross each
    /// other.
    std::uint64_t find(const Box& box, std::vector<std::uint32_t>& found,
                       std::size_t most = std::numeric_limits<std::size_t>::max()) const;

 private:
    struct Node {
        Box box;
        std::uint32_t begin, end;  ///< Of `order_`.
        std::uint32_t second;      ///< The second child; the first comes next. 0: a leaf.
    };
    void grow();
    void build(std::uint32_t node, std::uint32_t begin, std::uint32_t end);

    std::vector<Box> boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace hw
