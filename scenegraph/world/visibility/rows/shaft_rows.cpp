#include "hatchway/world/visibility/rows/shaft_rows.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "hatchway/world/visibility/rows/slot_triangles.hpp"

namespace hw {
namespace {

int longest_axis(const glm::dvec3& size)
{
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

double longest(const Box& box)
{
    const glm::dvec3 size = box.size();
    return size[longest_axis(size)];
}

/// A binary tree of boxes over things that have boxes.
struct BoxTree {
    struct Node {
        Box box;
        int first = 0, count = 0;  ///< Of `order`.
        int child = -1;            ///< The first of two; -1: none.
    };
    std::vector<int> order;
    std::vector<Node> nodes;
    std::vector<Box> leaf_boxes;  ///< As they were given.

    explicit BoxTree(std::span<const Box> boxes) : order(boxes.size()), leaf_boxes(boxes.begin(), boxes.end())
    {
        std::iota(order.begin(), order.end(), 0);
        if (boxes.empty()) return;
        nodes.push_back({{}, 0, static_cast<int>(boxes.size()), -1});
        for (std::size_t i = 0; i < nodes.size(); ++i) split(boxes, i);
    }

 private:
    void split(std::span<const Box> boxes, std::size_t index)
    {
        Node node = nodes[index];
        Box centres;
        for (int i = node.first; i < node.first + node.count; ++i) {
            const Box& box = boxes[static_cast<std::size_t>(order[static_cast<std::size_t>(i)])];
            node.box.add(box);
            centres.add(box.centre());
        }
        if (node.count > 1) {
            const int axis = longest_axis(centres.size());
            const auto begin = order.begin() + node.first;
            const int half = node.count / 2;
            std::stable_sort(begin, begin + node.count, [&](int a, int b) {
                return boxes[static_cast<std::size_t>(a)].centre()[axis] <
                       boxes[static_cast<std::size_t>(b)].centre()[axis];
            });
            node.child = static_cast<int>(nodes.size());
            nodes.push_back({{}, node.first, half, -1});
            nodes.push_back({{}, node.first + half, node.count - half, -1});
        }
        nodes[index] = node;
    }
};

struct TargetTriangle {
    glm::dvec3 normal{0.0};  ///< Unit; zero: drawn from both sides.
    double offset = 0.0;
    glm::dvec3 centre{0.0};

    /// Whether it is drawn for a place of the box; `slack` metres behind it count.
    bool may_face(const Box& eyes, double slack) const
    {
        if (normal == glm::dvec3(0.0)) return true;
        double most = offset;
        for (int axis = 0; axis < 3; ++axis)
            most += std::max(normal[axis] * eyes.min[axis], normal[axis] * eyes.max[axis]);
        return most > -slack;
    }
};

/// A slot as a tree of its triangles.
struct Target {
    std::vector<TargetTriangle> triangles;
    double slack = 0.0;  ///< Metres.
    BoxTree tree{{}};
};

Target make_target(const SlotPlaces& places, std::uint32_t slot)
{
    const glm::dvec3 origin = places.tree.grid.origin_world;
    Target target;
    target.slack = slack_m(places.tree.grid);
    std::vector<Box> boxes;
    for (const SlotTriangle& drawn : slot_triangles(places, slot)) {
        std::array<glm::dvec3, 3> corners;
        Box box;
        for (std::size_t k = 0; k < 3; ++k) {
            corners[k] = drawn.corners_world[k] - origin;
            box.add(corners[k]);
        }
        const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double length = glm::length(normal);
        if (!(length > 0.0)) continue;  // never drawn
        TargetTriangle triangle;
        triangle.normal = normal * (drawn.facing_sign / length);
        triangle.offset = -glm::dot(triangle.normal, corners[0]);
        triangle.centre = (corners[0] + corners[1] + corners[2]) / 3.0;
        target.triangles.push_back(triangle);
        boxes.push_back({box.min - target.slack, box.max + target.slack});
    }
    target.tree = BoxTree(boxes);
    return target;
}

/// A node of a tree, or a part of the box of a node without children.
struct Part {
    int node = 0;
    Box box;
};

std::array<Part, 2> halves(const BoxTree& tree, const Part& part)
{
    const int child = tree.nodes[static_cast<std::size_t>(part.node)].child;
    if (child >= 0) {
        return {Part{child, tree.nodes[static_cast<std::size_t>(child)].box},
                Part{child + 1, tree.nodes[static_cast<std::size_t>(child) + 1].box}};
    }
    std::array<Part, 2> result{part, part};
    const int axis = longest_axis(part.box.size());
    result[0].box.max[axis] = result[1].box.min[axis] = part.box.centre()[axis];
    return result;
}

/// The proof that a slot is hidden from a cell.
class Proof {
 public:
    /// `last` is a slice that is tried first, and becomes the one that hid something last.
    Proof(const SightSlices& slices, const BoxTree& eyes, const Target& target, std::int64_t most_shafts, int& last)
        : slices_(slices), eyes_(eyes), target_(target), left_(most_shafts), last_(last)
    {
    }

    bool holds()
    {
        const Part eyes{0, eyes_.nodes[0].box}, target{0, target_.tree.nodes[0].box};
        return !is_seen() && holds(eyes, target);
    }

 private:
    bool holds(const Part& eyes, const Part& target)
    {
        const int seen = facing_triangle(eyes.box, target.node);
        if (seen < 0) return true;
        if (--left_ < 0) return false;
        if (slices_.hides(eyes.box, target.box, last_)) return true;
        const int slice = slices_.cut(witness(eyes), target_.triangles[static_cast<std::size_t>(seen)].centre);
        if (slice < 0) return false;
        // On the slice a box shows the larger the farther the other one is from it.
        const FlowPlane& plane = slices_.slices()[static_cast<std::size_t>(slice)].plane;
        const double near = std::abs(plane.distance(eyes.box.centre()));
        const double far = std::abs(plane.distance(target.box.centre()));
        const bool halves_eyes = longest(eyes.box) * far > longest(target.box) * near;
        for (const Part& half : halves(halves_eyes ? eyes_ : target_.tree, halves_eyes ? eyes : target)) {
            if (!(halves_eyes ? holds(half, target) : holds(eyes, half))) return false;
        }
        return true;
    }

    /// Whether one of a few lines from places of the cell to triangles is not cut: cheaper than a proof that fails.
    bool is_seen() const
    {
        constexpr std::size_t kLines = 24;
        const std::size_t leaves = eyes_.order.size(), triangles = target_.triangles.size();
        int last = last_;
        for (std::size_t line = 0; line < kLines; ++line) {
            const Box& box = eyes_.leaf_boxes[(2 * line + 1) * leaves / (2 * kLines)];
            const glm::dvec3 share(place(2, line), place(3, line), place(5, line));
            const TargetTriangle& triangle = target_.triangles[(line * 7 % kLines * 2 + 1) * triangles / (2 * kLines)];
            const glm::dvec3 eye = box.min + box.size() * share;
            if (!triangle.may_face({eye, eye}, target_.slack)) continue;
            last = slices_.cut(eye, triangle.centre, last);
            if (last < 0) return true;
        }
        return false;
    }

    /// Number `index` of an even sequence in (0, 1). Van der Corput.
    static double place(std::size_t base, std::size_t index)
    {
        double share = 0.0, digit = 1.0;
        for (std::size_t rest = index + 1; rest > 0; rest /= base) {
            digit /= static_cast<double>(base);
            share += digit * static_cast<double>(rest % base);
        }
        return share;
    }

    /// A point where an eye can be.
    glm::dvec3 witness(const Part& eyes) const
    {
        int node = eyes.node;
        if (eyes_.nodes[static_cast<std::size_t>(node)].child < 0) return eyes.box.centre();
        while (eyes_.nodes[static_cast<std::size_t>(node)].child >= 0)
            node = eyes_.nodes[static_cast<std::size_t>(node)].child + static_cast<int>(left_ & 1);
        return eyes_.nodes[static_cast<std::size_t>(node)].box.centre();
    }

    /// A triangle of the node that may face the eyes; -1: none.
    int facing_triangle(const Box& eyes, int node) const
    {
        const BoxTree::Node& all = target_.tree.nodes[static_cast<std::size_t>(node)];
        for (int i = 0; i < all.count; ++i) {
            const int index = target_.tree.order[static_cast<std::size_t>(all.first + (i + all.count / 2) % all.count)];
            if (target_.triangles[static_cast<std::size_t>(index)].may_face(eyes, target_.slack)) return index;
        }
        return -1;
    }

    const SightSlices& slices_;
    const BoxTree& eyes_;
    const Target& target_;
    std::int64_t left_;
    int& last_;
};

std::vector<std::vector<Box>> boxes_of_cells(const BspTree& tree, std::span<const Box> leaf_boxes)
{
    std::vector<std::vector<Box>> result(static_cast<std::size_t>(tree.cluster_count));
    for (std::size_t leaf = 0; leaf < leaf_boxes.size(); ++leaf) {
        if (tree.is_solid[leaf] || leaf_boxes[leaf].is_empty()) continue;
        result[static_cast<std::size_t>(tree.cluster_of_leaf[leaf])].push_back(leaf_boxes[leaf]);
    }
    return result;
}

/// What of it is spent.
struct ShaftBudget {
    std::int64_t most_shafts = 0;  ///< For each pair of a cell and a slot.
    int stride = 1;                ///< Every so manieth cell is tried.
};

std::int64_t pair_count(const LeafRows& rows)
{
    std::int64_t count = 0;
    for (int leaf = 0; leaf < rows.leaf_count(); ++leaf) {
        for (const std::uint64_t word : rows.row(leaf)) count += __builtin_popcountll(word);
    }
    return count;
}

ShaftBudget budget_for(const ShaftOptions& options, const LeafRows& slot_rows)
{
    const std::int64_t pairs = std::max<std::int64_t>(1, pair_count(slot_rows));
    return {std::min(options.most_shafts, options.most_shafts_in_all / pairs + 1),
            static_cast<int>(pairs / options.most_pairs) + 1};
}

/// The cells, every `stride`th, from which a slot is hidden of those whose rows show it.
std::vector<int> cells_hidden_from(const SlotPlaces& places, const SightSlices& slices,
                                   std::span<const BoxTree> eyes_of_cell, const LeafRows& slot_rows, std::uint32_t slot,
                                   const ShaftBudget& budget)
{
    std::vector<int> hidden;
    const Object& object = places.scene.objects[places.slots[slot].object];
    if (places.scene.nodes[static_cast<std::size_t>(object.node)].is_animated) return hidden;
    std::optional<Target> target;
    int last = -1;
    for (int cell = 0; cell < slot_rows.leaf_count(); cell += budget.stride) {
        const BoxTree& eyes = eyes_of_cell[static_cast<std::size_t>(cell)];
        if (eyes.nodes.empty() || !slot_rows.sees(cell, static_cast<int>(slot))) continue;
        if (!target) target = make_target(places, slot);
        if (target->triangles.empty()) break;
        if (Proof(slices, eyes, *target, budget.most_shafts, last).holds()) hidden.push_back(cell);
    }
    return hidden;
}

}  // namespace

void hide_behind_slices(const SlotPlaces& places, const SightSlices& slices, std::span<const Box> leaf_boxes,
                        const ShaftOptions& options, LeafRows& slot_rows)
{
    const ShaftBudget budget = budget_for(options, slot_rows);
    std::vector<BoxTree> eyes_of_cell;
    for (const std::vector<Box>& boxes : boxes_of_cells(places.tree, leaf_boxes)) eyes_of_cell.emplace_back(boxes);
    // Slot by slot: the triangles of only a few slots are held at a time, however many the scene draws.
    std::vector<std::vector<int>> hidden(places.slots.size());
    std::atomic<std::size_t> done{0};
    tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
    arena.execute([&] {
        tbb::parallel_for(std::size_t{0}, hidden.size(), [&](std::size_t slot) {
            hidden[slot] =
                cells_hidden_from(places, slices, eyes_of_cell, slot_rows, static_cast<std::uint32_t>(slot), budget);
            if (options.progress) options.progress(static_cast<double>(++done) / static_cast<double>(hidden.size()));
        });
    });
    for (std::size_t slot = 0; slot < hidden.size(); ++slot) {
        for (const int cell : hidden[slot]) slot_rows.hide(cell, static_cast<int>(slot));
    }
}

}  // namespace hw
