#include "hatchway/geometry/lines/face_tree.hpp"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace hw {
namespace {

constexpr std::uint32_t kLeaf = 8;
constexpr std::uint32_t kWorthAThread = 10'000;
constexpr std::size_t kMostOpen = 64;  // the tree halves 2^32 boxes at most 29 times

/// Of a tree of so many boxes.
std::uint32_t node_count(std::uint32_t boxes)
{
    return boxes <= kLeaf ? 1 : 1 + node_count(boxes / 2) + node_count(boxes - boxes / 2);
}

std::vector<std::uint32_t> all_of(const std::vector<Box>& boxes)
{
    std::vector<std::uint32_t> all(boxes.size());
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

}  // namespace

FaceTree::FaceTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(all_of(boxes_))
{
    grow();
}

FaceTree::FaceTree(std::vector<Box> boxes, std::vector<std::uint32_t> some)
    : boxes_(std::move(boxes)), order_(std::move(some))
{
    grow();
}

void FaceTree::grow()
{
    const auto count = static_cast<std::uint32_t>(order_.size());
    if (count == 0) return;
    nodes_.resize(node_count(count));
    build(0, 0, count);
}

void FaceTree::build(std::uint32_t node, std::uint32_t begin, std::uint32_t end)
{
    Node& own = nodes_[node];
    own = {{}, begin, end, 0};
    for (std::uint32_t i = begin; i < end; ++i) own.box.add(boxes_[order_[i]]);
    if (end - begin <= kLeaf) return;
    const glm::dvec3 size = own.box.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t middle = begin + (end - begin) / 2;
    const auto centre = [&](std::uint32_t i) { return boxes_[i].min[axis] + boxes_[i].max[axis]; };
    std::nth_element(
        order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
        [&](std::uint32_t a, std::uint32_t b) { return centre(a) != centre(b) ? centre(a) < centre(b) : a < b; });
    own.second = node + 1 + node_count(middle - begin);
    const auto first_half = [&] { build(node + 1, begin, middle); };
    const auto second_half = [&] { build(own.second, middle, end); };
    if (end - begin >= kWorthAThread) return tbb::parallel_invoke(first_half, second_half);
    first_half();
    second_half();
}

std::uint64_t FaceTree::find(const Box& box, std::vector<std::uint32_t>& found, std::size_t most) const
{
    constexpr std::uint64_t kLookedAtOfFound = 4;
    const std::size_t found_before = found.size();
    const std::size_t enough = found.size() + std::min(most, order_.size());
    std::array<std::uint32_t, kMostOpen> open;
    std::size_t count = 0;
    if (!nodes_.empty()) open[count++] = 0;
    std::uint64_t looked_at = 0;
    while (count > 0 && found.size() < enough) {
        ++looked_at;
        const std::uint32_t at = open[--count];
        const Node& node = nodes_[at];
        if (!node.box.overlaps(box)) continue;
        if (node.second != 0) {
            open[count++] = at + 1;
            open[count++] = node.second;
            continue;
        }
        looked_at += node.end - node.begin;
        for (std::uint32_t i = node.begin; i < node.end; ++i)
            if (boxes_[order_[i]].overlaps(box)) found.push_back(order_[i]);
    }
    return found.size() - found_before + looked_at / kLookedAtOfFound;
}

}  // namespace hw
