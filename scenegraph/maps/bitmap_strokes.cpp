// The skeleton is a graph: nodes where lines end or meet, branches between them. Two lines that cross give four
// branches and often two nodes with a short bridge: nodes that are nearer than a line is wide are one, and at each node
// branches that go on straight become one stroke, as the hand drew it.
#include "hatchway/maps/bitmap_strokes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "hatchway/core/budget.hpp"
#include "hatchway/maps/thinning.hpp"

namespace hw {
namespace {

constexpr std::array<std::array<int, 2>, 8> kAround{
    {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}}};
constexpr double kStraightCosine = 0.6;   // branches that bend less than 53 degrees at a node are one stroke
constexpr double kDirectionPixels = 6.0;  // over which a branch's direction at its end is measured
constexpr double kSimplifyPixels = 0.4;
constexpr int kMostReach = 6;  // pixels around a skeleton's pixel of which the middle is taken
constexpr int kNoNode = -1;
constexpr std::size_t kMostEnds = 64;  // at a node; where more meet there is noise, and no branch goes on through it

using Points = std::vector<glm::dvec2>;

/// A line of pixels between two nodes; its places may leave the drawing where it crosses a side.
struct Branch {
    Points points;
    std::array<int, 2> node{kNoNode, kNoNode};  ///< At its beginning and its end.
    double width = 1.0;
    bool is_gone = false;
};

double length_of(const Points& points)
{
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) length += glm::distance(points[i - 1], points[i]);
    return length;
}

/// Follows the skeleton's pixels from node to node.
class Tracer {
 public:
    Tracer(const InkMask& lines, const InkMask& mask, const std::vector<float>& distance)
        : lines_(lines),
          mask_(mask),
          distance_(distance),
          used_(lines.ink.size(), 0),
          node_of_(lines.ink.size(), kNoNode)
    {
    }

    std::vector<Branch> branches()
    {
        for_each_pixel([&](int x, int y) {
            if (degree(x, y) != 2) node_of_[lines_.place(x, y)] = node_count_++;
        });
        for_each_pixel([&](int x, int y) {
            if (node_of_[lines_.place(x, y)] != kNoNode) trace_from(x, y);
        });
        for_each_pixel([&](int x, int y) {
            if (used_[lines_.place(x, y)] == 0) trace_from(x, y);  // closed lines have no node
        });
        return std::move(branches_);
    }
    int node_count() const { return node_count_; }

 private:
    template <typename Visit>
    void for_each_pixel(Visit visit) const
    {
        for (int y = 0; y < lines_.height; ++y)
            for (int x = 0; x < lines_.width; ++x)
                if (lines_.at(x, y)) visit(x, y);
    }
    /// Diagonal neighbours count where no straight one joins the two.
    bool is_linked(int x, int y, std::size_t way) const
    {
        const auto [dx, dy] = kAround[way];
        if (!lines_.at(x + dx, y + dy)) return false;
        return way % 2 == 0 || (!lines_.at(x + dx, y) && !lines_.at(x, y + dy));
    }
    int degree(int x, int y) const
    {
        int count = 0;
        for (std::size_t way = 0; way < 8; ++way) count += is_linked(x, y, way) ? 1 : 0;
        return count;
    }
    void trace_from(int x, int y)
    {
        int taken = 0;
        for (std::size_t way = 0; way < 8; ++way) {
            if (!is_linked(x, y, way)) continue;
            ++taken;
            if ((used_[lines_.place(x, y)] & (1u << way)) == 0) trace(x, y, way);
        }
        if (taken == 0) add_dot(x, y);
    }
    /// The middle of the ink around a pixel of the skeleton: lines of even width have it between two pixels.
    glm::dvec2 middle_of_ink(int x, int y) const
    {
        const int reach = std::min(static_cast<int>(std::ceil(distance_[lines_.place(x, y)])), kMostReach);
        glm::dvec2 sum(0.0);
        double count = 0.0;
        for (int dy = -reach; dy <= reach; ++dy)
            for (int dx = -reach; dx <= reach; ++dx) {
                if (!mask_.at(x + dx, y + dy)) continue;
                sum += glm::dvec2(dx, dy);
                count += 1.0;
            }
        return glm::dvec2(x + 0.5, y + 0.5) + sum / std::max(count, 1.0);
    }
    void add_branch(Branch branch)
    {
        Budget().require(Cost::strokes, branches_.size(), "", "");
        branches_.push_back(std::move(branch));
    }
    void add_dot(int x, int y)
    {
        used_[lines_.place(x, y)] = 0xff;
        const int node = node_of_[lines_.place(x, y)];
        add_branch({{middle_of_ink(x, y)}, {node, node}, 2.0 * distance_[lines_.place(x, y)], false});
    }
    void trace(int x, int y, std::size_t way)
    {
        Branch branch;
        branch.node[0] = node_of_[lines_.place(x, y)];
        double width = 0.0;
        const auto add = [&] {
            branch.points.push_back(middle_of_ink(x, y));
            width += 2.0 * distance_[lines_.place(x, y)] - 1.0;
        };
        add();
        const std::size_t start = lines_.place(x, y);
        while (true) {
            used_[lines_.place(x, y)] |= static_cast<std::uint8_t>(1u << way);
            x += kAround[way][0];
            y += kAround[way][1];
            const std::size_t back = (way + 4) % 8;
            const std::size_t here = lines_.place(x, y);
            used_[here] |= static_cast<std::uint8_t>(1u << back);
            add();
            if (node_of_[here] != kNoNode || here == start) break;
            way = 0;
            while (way < 8 && (way == back || !is_linked(x, y, way))) ++way;
            if (way == 8) break;
        }
        branch.node[1] = node_of_[lines_.place(x, y)];
        branch.width = std::max(width / static_cast<double>(branch.points.size()), 1.0);
        add_branch(std::move(branch));
    }

    const InkMask& lines_;
    const InkMask& mask_;
    const std::vector<float>& distance_;
    std::vector<std::uint8_t> used_;  ///< Ways that have been taken, a bit each.
    std::vector<int> node_of_;
    int node_count_ = 0;
    std::vector<Branch> branches_;
};

/// One end of a branch: which, and whether its beginning (0) or its end (1).
struct BranchEnd {
    std::size_t branch;
    int side;
};

/// Unit, out of the node into the branch.
glm::dvec2 direction_from(const Branch& branch, int side)
{
    const std::size_t count = branch.points.size();
    const auto at = [&](std::size_t i) { return branch.points[side == 0 ? i : count - 1 - i]; };
    std::size_t i = std::min<std::size_t>(1, count - 1);
    while (i + 1 < count && glm::distance(at(i), at(0)) < kDirectionPixels) ++i;
    const glm::dvec2 d = at(i) - at(0);
    const double length = glm::length(d);
    return length > 0.0 ? d / length : glm::dvec2(0.0);
}

class StrokeJoiner {
 public:
    StrokeJoiner(std::vector<Branch> branches, int node_count, const glm::dvec2& size, const BitmapStrokesDesc& desc)
        : branches_(std::move(branches)), size_(size), desc_(desc), merged_(static_cast<std::size_t>(node_count))
    {
        std::iota(merged_.begin(), merged_.end(), 0);
    }

    /// Polylines in pixels, with widths.
    std::vector<Branch> strokes()
    {
        merge_bridged_nodes();
        remove_burrs();
        pair_ends();
        return follow();
    }

 private:
    int root_of(int node)
    {
        while (merged_[node] != node) node = merged_[node] = merged_[merged_[node]];
        return node;
    }
    std::vector<int> degrees()
    {
        std::vector<int> result(merged_.size(), 0);
        for (const Branch& branch : branches_)
            for (const int node : branch.node)
                if (!branch.is_gone && node != kNoNode) ++result[root_of(node)];
        return result;
    }
    void merge_bridged_nodes()
    {
        const std::vector<int> degree = degrees();
        for (Branch& branch : branches_) {
            const auto [a, b] = branch.node;
            if (a == kNoNode || b == kNoNode || a == b || degree[a] < 3 || degree[b] < 3) continue;
            if (length_of(branch.points) > 1.2 * branch.width + 1.0) continue;
            branch.is_gone = true;
            merged_[root_of(a)] = root_of(b);
        }
    }
    void remove_burrs()
    {
        const std::vector<int> degree = degrees();
        for (Branch& branch : branches_) {
            if (branch.is_gone || branch.node[0] == kNoNode || branch.node[1] == kNoNode) continue;
            const int a = degree[root_of(branch.node[0])];
            const int b = degree[root_of(branch.node[1])];
            const bool is_end = std::min(a, b) == 1 && std::max(a, b) >= 3;
            if (is_end && length_of(branch.points) < desc_.burr_widths * branch.width + 1.5) branch.is_gone = true;
        }
    }
    void pair_ends()
    {
        partner_.assign(branches_.size(), {BranchEnd{branches_.size(), 0}, BranchEnd{branches_.size(), 0}});
        std::vector<std::vector<BranchEnd>> ends(merged_.size());
        for (std::size_t i = 0; i < branches_.size(); ++i)
            for (int side = 0; side < 2; ++side)
                if (!branches_[i].is_gone && branches_[i].node[side] != kNoNode && branches_[i].points.size() > 1)
                    ends[root_of(branches_[i].node[side])].push_back({i, side});
        for (const std::vector<BranchEnd>& at_node : ends)
            if (at_node.size() <= kMostEnds) pair_straightest(at_node);
    }
    void pair_straightest(const std::vector<BranchEnd>& ends)
    {
        struct Pair {
            double cosine;
            BranchEnd a;
            BranchEnd b;
        };
        std::vector<Pair> pairs;
        for (std::size_t i = 0; i < ends.size(); ++i)
            for (std::size_t j = i + 1; j < ends.size(); ++j) {
                const double cosine = -glm::dot(direction_from(branches_[ends[i].branch], ends[i].side),
                                                direction_from(branches_[ends[j].branch], ends[j].side));
                if (cosine > kStraightCosine && ends[i].branch != ends[j].branch)
                    pairs.push_back({cosine, ends[i], ends[j]});
            }
        std::ranges::stable_sort(pairs, std::ranges::greater(), &Pair::cosine);
        const auto is_free = [&](const BranchEnd& end) {
            return partner_[end.branch][end.side].branch == branches_.size();
        };
        for (const Pair& pair : pairs) {
            if (!is_free(pair.a) || !is_free(pair.b)) continue;
            partner_[pair.a.branch][pair.a.side] = pair.b;
            partner_[pair.b.branch][pair.b.side] = pair.a;
        }
    }
    std::vector<Branch> follow()
    {
        std::vector<Branch> strokes;
        std::vector<bool> is_done(branches_.size(), false);
        for (std::size_t i = 0; i < branches_.size(); ++i) {
            if (is_done[i] || branches_[i].is_gone) continue;
            strokes.push_back(stroke_through(first_end(i), is_done));
        }
        return strokes;
    }
    /// Where the stroke that holds the branch begins; anywhere on a closed one.
    BranchEnd first_end(std::size_t branch) const
    {
        BranchEnd end{branch, 0};
        while (true) {
            const BranchEnd before = partner_[end.branch][end.side];
            if (before.branch == branches_.size()) return end;
            end = {before.branch, 1 - before.side};
            if (end.branch == branch) return end;
        }
    }
    Branch stroke_through(BranchEnd end, std::vector<bool>& is_done) const
    {
        Branch stroke;
        double width_sum = 0.0;
        while (end.branch != branches_.size() && !is_done[end.branch]) {
            const Branch& branch = branches_[end.branch];
            is_done[end.branch] = true;
            Points points = branch.points;
            if (end.side == 1) std::ranges::reverse(points);
            width_sum += branch.width * static_cast<double>(points.size());
            // A branch may have been traced on the other side of the drawing's border: it goes on where the last one
            // ended.
            const glm::dvec2 shift =
                stroke.points.empty() ? glm::dvec2(0.0) : border_shift(stroke.points.back(), points.front());
            for (const glm::dvec2& p : points) stroke.points.push_back(p + shift);
            end = partner_[end.branch][1 - end.side];
        }
        stroke.width = width_sum / static_cast<double>(stroke.points.size());
        return stroke;
    }
    glm::dvec2 border_shift(const glm::dvec2& from, const glm::dvec2& to) const
    {
        return glm::round((from - to) / size_) * size_;
    }

    std::vector<Branch> branches_;
    glm::dvec2 size_;  ///< Of the drawing, pixels.
    const BitmapStrokesDesc& desc_;
    std::vector<int> merged_;
    std::vector<std::array<BranchEnd, 2>> partner_;
};

/// Takes the stairs of pixels out of a line; its ends stay.
Points smoothed(Points points)
{
    for (int round = 0; round < 3; ++round) {
        const Points before = points;
        for (std::size_t i = 1; i + 1 < points.size(); ++i)
            points[i] = 0.25 * (before[i - 1] + 2.0 * before[i] + before[i + 1]);
    }
    return points;
}

/// Between two points of a line, the one that is farthest from the straight way; `first` where all are near it.
std::size_t farthest_between(const Points& points, std::size_t first, std::size_t last)
{
    const glm::dvec2 d = points[last] - points[first];
    const double length = glm::length(d);
    std::size_t farthest = first;
    double most = kSimplifyPixels;
    for (std::size_t i = first + 1; i < last; ++i) {
        const glm::dvec2 p = points[i] - points[first];
        const double away = length > 0.0 ? std::abs(p.x * d.y - p.y * d.x) / length : glm::length(p);
        if (away > most) {
            most = away;
            farthest = i;
        }
    }
    return farthest;
}

/// Douglas and Peucker.
Points simplified(const Points& points)
{
    Points result{points.front()};
    std::vector<std::size_t> ends{points.size() - 1};  // of the parts that are not done, the nearest last
    for (std::size_t first = 0; !ends.empty();) {
        const std::size_t farthest = farthest_between(points, first, ends.back());
        if (farthest != first) {
            ends.push_back(farthest);
            continue;
        }
        first = ends.back();
        ends.pop_back();
        if (first > 0) result.push_back(points[first]);
    }
    return result;
}

double median_width(std::vector<Branch>& strokes)
{
    std::vector<double> widths;
    for (const Branch& stroke : strokes) widths.push_back(stroke.width);
    const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
    std::nth_element(widths.begin(), middle, widths.end());
    return std::max(*middle, 1e-6);
}

}  // namespace

std::vector<MapStroke> strokes_of_bitmap(const Pixels& drawing, const BitmapStrokesDesc& desc)
{
    const InkMask mask = ink_of(drawing, desc.ink_below);
    const std::vector<float> distance = distance_to_paper(mask);
    const InkMask lines = thinned(mask);
    Tracer tracer(lines, mask, distance);
    std::vector<Branch> branches = tracer.branches();
    const glm::dvec2 size(drawing.width, drawing.height);
    std::vector<Branch> found = StrokeJoiner(std::move(branches), tracer.node_count(), size, desc).strokes();
    std::vector<MapStroke> strokes;
    if (found.empty()) return strokes;
    const double median = median_width(found);
    for (const Branch& stroke : found) {
        const Points points = smoothed(stroke.points);
        Points simple = simplified(points);
        for (glm::dvec2& p : simple) p /= size;
        strokes.push_back({.points = std::move(simple), .width = std::clamp(stroke.width / median, 0.25, 8.0)});
    }
    return strokes;
}

}  // namespace hw
