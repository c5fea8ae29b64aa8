#include "hatchway/geometry/lines/face_tree.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace hw {
namespace {

constexpr std::uint32_t kLeaf = 8;
constexpr std::size_t kMostOpen = 64;  // the tree halves 2^32 boxes at most 29 times

}  // namespace

FaceTree::FaceTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size())
{
    std::iota(order_.begin(), order_.end(), 0u);
    if (!boxes_.empty()) build(0, static_cast<std::uint32_t>(boxes_.size()));
}

void FaceTree::build(std::uint32_t begin, std::uint32_t end)
{
    const std::size_t own = nodes_.size();
    nodes_.push_back({{}, begin, end, 0});
    for (std::uint32_t i = begin; i < end; ++i) nodes_[own].box.add(boxes_[order_[i]]);
    if (end - begin <= kLeaf) return;
    const glm::dvec3 size = nodes_[own].box.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t middle = begin + (end - begin) / 2;
    const auto centre = [&](std::uint32_t i) { return boxes_[i].min[axis] + boxes_[i].max[axis]; };
    std::nth_element(
        order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
        [&](std::uint32_t a, std::uint32_t b) { return centre(a) != centre(b) ? centre(a) < centre(b) : a < b; });
    build(begin, middle);
    nodes_[own].second = static_cast<std::uint32_t>(nodes_.size());
    build(middle, end);
}

void FaceTree::find(const Box& box, std::vector<std::uint32_t>& found, std::size_t most) const
{
    const std::size_t enough = found.size() + std::min(most, boxes_.size());
    std::array<std::uint32_t, kMostOpen> open;
    std::size_t count = 0;
    if (!nodes_.empty()) open[count++] = 0;
    while (count > 0 && found.size() < enough) {
        const std::uint32_t at = open[--count];
        const Node& node = nodes_[at];
        if (!node.box.overlaps(box)) continue;
        if (node.second != 0) {
            open[count++] = at + 1;
            open[count++] = node.second;
            continue;
        }
        for (std::uint32_t i = node.begin; i < node.end; ++i)
            if (boxes_[order_[i]].overlaps(box)) found.push_back(order_[i]);
    }
}

}  // namespace hw
