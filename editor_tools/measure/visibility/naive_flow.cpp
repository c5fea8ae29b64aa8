#include "measure/visibility/naive_flow.hpp"

#include <algorithm>
#include <bit>
#include <deque>
#include <glm/geometric.hpp>

namespace hw::measure {
namespace {

using Bits = std::vector<std::uint64_t>;  // 64 leaves a word

bool holds(const Bits& bits, std::size_t i)
{
    return (bits[i / 64] >> (i % 64) & 1u) != 0;
}

void set(Bits& bits, std::size_t i)
{
    bits[i / 64] |= std::uint64_t{1} << (i % 64);
}

std::size_t count(const Bits& bits)
{
    std::size_t sum = 0;
    for (const std::uint64_t word : bits) sum += static_cast<std::size_t>(std::popcount(word));
    return sum;
}

FlowPlane turned(const FlowPlane& plane)
{
    return {-plane.normal, -plane.offset};
}

struct Opening {
    int to_leaf = 0;
    FlowPlane ahead;
    Winding points;
    Bits may_see;
    Bits sees;
    bool is_done = false;
};

/// What lies in front of the plane, or at most the slack behind it; empty if no point reaches the least distance.
Winding kept(const Winding& points, const FlowPlane& plane, const ClipTolerance& tolerance)
{
    std::array<double, Winding::kMostCorners> distances;  // NOLINT: filled below
    double farthest = 0.0;
    for (int i = 0; i < points.count; ++i) {
        const double distance = plane.distance(points[i]);
        farthest = std::max(farthest, distance);
        distances[i] = distance + tolerance.slack;
    }
    if (farthest < tolerance.least) return {};
    if (points.count == Winding::kMostCorners) return points;
    Winding result;
    for (int i = 0; i < points.count; ++i) {
        const int next = (i + 1) % points.count;
        if (distances[i] >= 0.0) result.points[result.count++] = points[i];
        if ((distances[i] >= 0.0) == (distances[next] >= 0.0)) continue;
        const double share = distances[i] / (distances[i] - distances[next]);
        result.points[result.count++] = points[i] + share * (points[next] - points[i]);
    }
    return result;
}

/// The plane through an edge of `from` and a point of `through` that has all of `from` behind and all of `through` in
/// front, if it has.
bool separates(const Winding& from, int edge, const Winding& through, int corner, double slack, FlowPlane& plane)
{
    const glm::dvec3 a = from[edge], side = from[(edge + 1) % from.count] - a;
    const glm::dvec3 normal = glm::cross(side, through[corner] - a);
    const double length = glm::length(normal);
    if (glm::length(side) < slack || length < slack * glm::length(side)) return false;
    plane.normal = normal / length;
    plane.offset = -glm::dot(plane.normal, a);
    bool is_behind = false, is_ahead = false;
    for (int i = 0; i < from.count; ++i) {
        is_behind |= plane.distance(from[i]) < -slack;
        is_ahead |= plane.distance(from[i]) > slack;
    }
    if (is_behind == is_ahead) return false;
    if (is_ahead) plane = turned(plane);
    bool is_beyond = false;
    for (int i = 0; i < through.count; ++i) {
        if (plane.distance(through[i]) < -slack) return false;
        is_beyond |= plane.distance(through[i]) > slack;
    }
    return is_beyond;
}

/// What of `target` can be reached by lines from `from` through `through`. `is_swapped`: planes lie on edges of the
/// second of two openings in a row, so what they keep is behind them.
Winding between(const Winding& from, const Winding& through, Winding target, bool is_swapped,
                const ClipTolerance& tolerance)
{
    for (int edge = 0; edge < from.count && target.count > 0; ++edge) {
        for (int corner = 0; corner < through.count; ++corner) {
            FlowPlane plane;
            if (!separates(from, edge, through, corner, tolerance.slack, plane)) continue;
            target = kept(target, is_swapped ? turned(plane) : plane, tolerance);
            if (target.count == 0) break;
        }
    }
    return target;
}

class NaiveFlow {
 public:
    NaiveFlow(const PortalGraph& graph, const ClipTolerance& tolerance)
        : leaf_count_(static_cast<std::size_t>(graph.leaf_count)),
          word_count_((leaf_count_ + 63) / 64),
          tolerance_(tolerance),
          out_of_(leaf_count_),
          is_on_way_(graph.portals.size())
    {
        for (const DirectedPortal& portal : graph.portals) {
            out_of_[static_cast<std::size_t>(portal.from_leaf)].push_back(openings_.size());
            openings_.push_back(
                {portal.to_leaf, {portal.normal, portal.offset}, Winding(portal.winding), {}, {}, false});
        }
        for (Opening& opening : openings_) flood(opening);
    }

    void run(const std::vector<int>& from_leaves)
    {
        std::vector<std::size_t> order;
        for (const int leaf : from_leaves) {
            const auto& out = out_of_[static_cast<std::size_t>(leaf)];
            order.insert(order.end(), out.begin(), out.end());
        }
        const auto size = [&](std::size_t i) { return count(openings_[i].may_see); };
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return size(a) < size(b); });
        for (const std::size_t number : order) {
            source_ = &openings_[number];
            source_->sees.assign(word_count_, 0);
            go_on(source_->to_leaf, source_->points, {}, {}, source_->may_see, 0);
            source_->is_done = true;
        }
    }

    void add_row(int leaf, LeafRows& rows) const
    {
        rows.show(leaf, leaf);
        for (const std::size_t number : out_of_[static_cast<std::size_t>(leaf)]) {
            const Bits& sees = openings_[number].sees;
            for (std::size_t i = 0; i < leaf_count_ && !sees.empty(); ++i)
                if (holds(sees, i)) rows.show(leaf, static_cast<int>(i));
        }
    }

 private:
    bool reaches(const Winding& points, const FlowPlane& plane) const
    {
        return std::any_of(points.points.begin(), points.points.begin() + points.count,
                           [&](const glm::dvec3& point) { return plane.distance(point) > tolerance_.least; });
    }

    bool may_follow(const Opening& first, const Opening& later) const
    {
        return reaches(later.points, first.ahead) && reaches(first.points, turned(later.ahead));
    }

    void flood(Opening& source)
    {
        source.may_see.assign(word_count_, 0);
        set(source.may_see, static_cast<std::size_t>(source.to_leaf));
        std::vector<int> pending{source.to_leaf};
        while (!pending.empty()) {
            const auto leaf = static_cast<std::size_t>(pending.back());
            pending.pop_back();
            for (const std::size_t number : out_of_[leaf]) {
                const Opening& opening = openings_[number];
                const auto to_leaf = static_cast<std::size_t>(opening.to_leaf);
                if (holds(source.may_see, to_leaf) || !may_follow(source, opening)) continue;
                set(source.may_see, to_leaf);
                pending.push_back(opening.to_leaf);
            }
        }
    }

    void go_on(int leaf, const Winding& from, const Winding& through, const FlowPlane& through_plane,
               const Bits& may_see, std::size_t depth)
    {
        if (left_.size() == depth) left_.emplace_back(word_count_);
        Bits& left = left_[depth];
        set(source_->sees, static_cast<std::size_t>(leaf));
        for (const std::size_t number : out_of_[static_cast<std::size_t>(leaf)]) {
            const Opening& opening = openings_[number];
            if (!holds(may_see, static_cast<std::size_t>(opening.to_leaf)) || is_on_way_[number]) continue;
            const Bits& behind = opening.is_done ? opening.sees : opening.may_see;
            std::uint64_t news = 0;
            for (std::size_t i = 0; i < word_count_; ++i) {
                left[i] = may_see[i] & behind[i];
                news |= left[i] & ~source_->sees[i];
            }
            if (news == 0) continue;
            Winding target = kept(opening.points, source_->ahead, tolerance_);
            Winding source = kept(from, turned(opening.ahead), tolerance_);
            if (through.count > 0) {
                target = kept(target, through_plane, tolerance_);
                target = between(source, through, target, false, tolerance_);
                target = between(through, source, target, true, tolerance_);
                source = between(target, through, source, false, tolerance_);
                source = between(through, target, source, true, tolerance_);
            }
            if (target.count == 0 || source.count == 0) continue;
            is_on_way_[number] = true;
            go_on(opening.to_leaf, source, target, opening.ahead, left, depth + 1);
            is_on_way_[number] = false;
        }
    }

    std::size_t leaf_count_;
    std::size_t word_count_;
    ClipTolerance tolerance_;
    std::vector<Opening> openings_;
    std::vector<std::vector<std::size_t>> out_of_;
    std::vector<char> is_on_way_;
    std::deque<Bits> left_;  ///< By depth: what may be seen from there on. References to it stay.
    Opening* source_ = nullptr;
};

}  // namespace

LeafRows naive_flow(const PortalGraph& graph, const std::vector<int>& from_leaves, const ClipTolerance& tolerance)
{
    NaiveFlow flow(graph, tolerance);
    flow.run(from_leaves);
    LeafRows rows(graph.leaf_count, graph.leaf_count);
    for (const int leaf : from_leaves) flow.add_row(leaf, rows);
    return rows;
}

}  // namespace hw::measure
