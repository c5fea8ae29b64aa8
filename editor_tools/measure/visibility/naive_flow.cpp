#include "measure/visibility/naive_flow.hpp"

#include <algorithm>
#include <bit>
#include <glm/geometric.hpp>

namespace hw::measure {
namespace {

using Points = std::vector<glm::dvec3>;
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

struct HalfSpace {
    glm::dvec3 normal{0.0};
    double offset = 0.0;
    double distance(const glm::dvec3& p) const { return glm::dot(normal, p) + offset; }
    HalfSpace turned() const { return {-normal, -offset}; }
};

struct Opening {
    int to_leaf = 0;
    HalfSpace ahead;
    Points points;
    Bits may_see;
    Bits sees;
    bool is_done = false;
};

/// What lies in the half-space; empty if no point is inside by more than the tolerance.
Points kept(const Points& points, const HalfSpace& space, double tolerance)
{
    std::vector<double> distances;
    for (const glm::dvec3& point : points) distances.push_back(space.distance(point));
    if (points.empty() || *std::max_element(distances.begin(), distances.end()) <= tolerance) return {};
    Points result;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t next = (i + 1) % points.size();
        if (distances[i] >= -tolerance) result.push_back(points[i]);
        const bool leaves = distances[i] > tolerance && distances[next] < -tolerance;
        const bool enters = distances[i] < -tolerance && distances[next] > tolerance;
        if (!leaves && !enters) continue;
        const double share = distances[i] / (distances[i] - distances[next]);
        result.push_back(points[i] + share * (points[next] - points[i]));
    }
    return result;
}

/// The plane through an edge of `from` and a point of `through` that has all of `from` behind and all of `through` in
/// front, if it has.
bool separates(const Points& from, std::size_t edge, const Points& through, std::size_t corner, double tolerance,
               HalfSpace& plane)
{
    const glm::dvec3 a = from[edge], b = from[(edge + 1) % from.size()];
    const glm::dvec3 normal = glm::cross(b - a, through[corner] - a);
    const double length = glm::length(normal);
    if (length < 1e-9) return false;
    plane.normal = normal / length;
    plane.offset = -glm::dot(plane.normal, a);
    bool is_behind = false, is_ahead = false;
    for (const glm::dvec3& point : from) {
        is_behind |= plane.distance(point) < -tolerance;
        is_ahead |= plane.distance(point) > tolerance;
    }
    if (is_behind == is_ahead) return false;
    if (is_ahead) plane = plane.turned();
    bool is_beyond = false;
    for (const glm::dvec3& point : through) {
        if (plane.distance(point) < -tolerance) return false;
        is_beyond |= plane.distance(point) > tolerance;
    }
    return is_beyond;
}

/// What of `target` can be reached by lines from `from` through `through`. `is_swapped`: planes lie on edges of the
/// second of two openings in a row, so what they keep is behind them.
Points between(const Points& from, const Points& through, Points target, bool is_swapped, double tolerance)
{
    for (std::size_t edge = 0; edge < from.size() && !target.empty(); ++edge) {
        for (std::size_t corner = 0; corner < through.size(); ++corner) {
            HalfSpace plane;
            if (!separates(from, edge, through, corner, tolerance, plane)) continue;
            target = kept(target, is_swapped ? plane.turned() : plane, tolerance);
            if (target.empty()) break;
        }
    }
    return target;
}

class NaiveFlow {
 public:
    NaiveFlow(const PortalGraph& graph, double tolerance)
        : leaf_count_(static_cast<std::size_t>(graph.leaf_count)),
          word_count_((leaf_count_ + 63) / 64),
          tolerance_(tolerance),
          out_of_(leaf_count_),
          is_on_way_(graph.portals.size())
    {
        for (const DirectedPortal& portal : graph.portals) {
            out_of_[static_cast<std::size_t>(portal.from_leaf)].push_back(openings_.size());
            openings_.push_back({portal.to_leaf, {portal.normal, portal.offset}, portal.winding, {}, {}, false});
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
            go_on(source_->to_leaf, source_->points, {}, {}, source_->may_see);
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
    bool may_follow(const Opening& first, const Opening& later) const
    {
        const auto is_ahead = [&](const HalfSpace& plane) {
            return [&, plane](const glm::dvec3& point) { return plane.distance(point) > tolerance_; };
        };
        return std::any_of(later.points.begin(), later.points.end(), is_ahead(first.ahead)) &&
               std::any_of(first.points.begin(), first.points.end(), is_ahead(later.ahead.turned()));
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

    void go_on(int leaf, const Points& from, const Points& through, const HalfSpace& through_plane, const Bits& may_see)
    {
        set(source_->sees, static_cast<std::size_t>(leaf));
        for (const std::size_t number : out_of_[static_cast<std::size_t>(leaf)]) {
            const Opening& opening = openings_[number];
            if (!holds(may_see, static_cast<std::size_t>(opening.to_leaf)) || is_on_way_[number]) continue;
            const Bits& behind = opening.is_done ? opening.sees : opening.may_see;
            Bits left(word_count_);
            std::uint64_t news = 0;
            for (std::size_t i = 0; i < word_count_; ++i) {
                left[i] = may_see[i] & behind[i];
                news |= left[i] & ~source_->sees[i];
            }
            if (news == 0) continue;
            Points target = kept(opening.points, source_->ahead, tolerance_);
            Points source = kept(from, opening.ahead.turned(), tolerance_);
            if (!through.empty() && !target.empty()) target = kept(target, through_plane, tolerance_);
            if (!through.empty()) {
                target = between(source, through, target, false, tolerance_);
                target = between(through, source, target, true, tolerance_);
                source = between(target, through, source, false, tolerance_);
                source = between(through, target, source, true, tolerance_);
            }
            if (target.empty() || source.empty()) continue;
            is_on_way_[number] = true;
            go_on(opening.to_leaf, source, target, opening.ahead, left);
            is_on_way_[number] = false;
        }
    }

    std::size_t leaf_count_;
    std::size_t word_count_;
    double tolerance_;
    std::vector<Opening> openings_;
    std::vector<std::vector<std::size_t>> out_of_;
    std::vector<char> is_on_way_;
    Opening* source_ = nullptr;
};

}  // namespace

LeafRows naive_flow(const PortalGraph& graph, const std::vector<int>& from_leaves, double tolerance)
{
    NaiveFlow flow(graph, tolerance);
    flow.run(from_leaves);
    LeafRows rows(graph.leaf_count, graph.leaf_count);
    for (const int leaf : from_leaves) flow.add_row(leaf, rows);
    return rows;
}

}  // namespace hw::measure
