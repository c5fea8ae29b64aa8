// Of two segments that overlap, one has an end on the other. So every segment is strewn into cells along its length,
// and every end asks its neighbourhood for the segments that it lies on.
#include "hatchway/geometry/lines/line_groups.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <mutex>
#include <unordered_map>

#include "hatchway/core/disjoint_sets.hpp"

namespace hw {
namespace {

constexpr double kDriftPerLength = 1e-6;  // lines of rounded ends turn a little
constexpr std::uint32_t kMostSamples = 4096;
constexpr std::size_t kMostPairs = 65536;             // kept before they are joined
constexpr std::uint64_t kMostCompared = 200'000'000;  // segments with ends; past that none is grouped

double length_of(const Segment& segment)
{
    return glm::distance(segment.from, segment.to);
}

double distance_to(const glm::dvec3& point, const Segment& segment)
{
    const glm::dvec3 along = segment.to - segment.from;
    const double t = glm::dot(point - segment.from, along) / glm::dot(along, along);
    return glm::distance(point, segment.from + std::clamp(t, 0.0, 1.0) * along);
}

/// Whether both ends of a segment lie on the line through a longer one.
bool is_on_line(const Segment& segment, const Segment& longer, double tolerance)
{
    const glm::dvec3 direction = glm::normalize(longer.to - longer.from);
    for (const glm::dvec3& end : {segment.from, segment.to}) {
        const glm::dvec3 offset = end - longer.from;
        const double along = glm::dot(offset, direction);
        if (glm::length(offset - along * direction) > tolerance + kDriftPerLength * std::abs(along)) return false;
    }
    return true;
}

class LineGroups {
 public:
    LineGroups(std::span<const Segment> segments, double tolerance)
        : segments_(segments), tolerance_(tolerance), sets_(segments.size())
    {
        double sum = 0.0;
        for (const Segment& segment : segments) sum += length_of(segment);
        cell_ = std::max(64.0 * tolerance, segments.empty() ? 1.0 : sum / static_cast<double>(segments.size()));
    }

    std::vector<std::vector<std::uint32_t>> run()
    {
        strew();
        compared_ = comparisons();
        if (compared_ > kMostCompared) return {};
        tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, static_cast<std::uint32_t>(segments_.size())),
                          [&](const auto& range) { join_all(range.begin(), range.end()); });
        std::vector<std::uint32_t> count(segments_.size(), 0);
        for (std::uint32_t i = 0; i < segments_.size(); ++i) ++count[sets_.of(i)];
        std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> by_root;
        for (std::uint32_t i = 0; i < segments_.size(); ++i)
            if (count[sets_.of(i)] > 1) by_root[sets_.of(i)].push_back(i);
        std::vector<std::vector<std::uint32_t>> groups;
        for (std::uint32_t i = 0; i < segments_.size(); ++i)
            if (sets_.of(i) == i && count[i] > 1) split_into_lines(std::move(by_root[i]), groups);
        return groups;
    }

 private:
    struct Entry {
        std::uint64_t cell;
        std::uint32_t segment;
    };

    bool is_used(std::uint32_t i) const { return length_of(segments_[i]) > tolerance_; }

    std::uint64_t cell_key(const glm::dvec3& cell) const
    {
        const auto part = [](double x) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(x)) & 0x1fffff; };
        return part(cell.x) << 42 | part(cell.y) << 21 | part(cell.z);  // cells that share a key cost comparisons only
    }

    void strew()
    {
        for (std::uint32_t i = 0; i < segments_.size(); ++i) {
            if (!is_used(i)) continue;
            const Segment& segment = segments_[i];
            const auto count = std::min(kMostSamples, 1 + static_cast<std::uint32_t>(2.0 * length_of(segment) / cell_));
            std::uint64_t last = ~std::uint64_t{0};
            for (std::uint32_t k = 0; k <= count; ++k) {
                const glm::dvec3 at = glm::mix(segment.from, segment.to, static_cast<double>(k) / count);
                const std::uint64_t key = cell_key(glm::floor(at / cell_));
                if (key != last) entries_.push_back({key, i});
                last = key;
            }
        }
        tbb::parallel_sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
            return a.cell != b.cell ? a.cell < b.cell : a.segment < b.segment;
        });
        first_.reserve(entries_.size());
        for (std::uint32_t i = 0; i < entries_.size(); ++i) first_.try_emplace(entries_[i].cell, i);
    }

    using Pairs = std::vector<std::array<std::uint32_t, 2>>;

    /// The groups are the same in whatever order pairs are joined.
    void join_all(std::uint32_t begin, std::uint32_t end)
    {
        Pairs pairs;
        const auto join_found = [&] {
            const std::lock_guard lock(joining_);
            for (const auto& [a, b] : pairs) sets_.join(a, b);
            pairs.clear();
        };
        for (std::uint32_t i = begin; i < end; ++i) {
            if (!is_used(i)) continue;
            find_at(i, segments_[i].from, pairs);
            find_at(i, segments_[i].to, pairs);
            if (pairs.size() > kMostPairs) join_found();
        }
        join_found();
    }

    /// How many segments find_at() looks at for all ends.
    std::uint64_t comparisons() const
    {
        const auto at_cell = [&](std::uint64_t cell) -> std::uint64_t {
            const auto found = first_.find(cell);
            if (found == first_.end()) return 0;
            const auto begin = entries_.begin() + found->second;
            const auto is_before = [](std::uint64_t key, const Entry& entry) { return key < entry.cell; };
            return static_cast<std::uint64_t>(std::upper_bound(begin, entries_.end(), cell, is_before) - begin);
        };
        return tbb::parallel_reduce(
            tbb::blocked_range<std::size_t>(0, segments_.size()), std::uint64_t{0},
            [&](const auto& range, std::uint64_t sum) {
                for (std::size_t i = range.begin(); i < range.end(); ++i) {
                    if (!is_used(static_cast<std::uint32_t>(i))) continue;
                    for (const glm::dvec3& end : {segments_[i].from, segments_[i].to})
                        for_each_cell_near(end, [&](std::uint64_t cell) { sum += at_cell(cell); });
                }
                return sum;
            },
            std::plus<>());
    }

    void find_at(std::uint32_t index, const glm::dvec3& end, Pairs& pairs) const
    {
        for_each_cell_near(end, [&](std::uint64_t cell) { find_in_cell(index, end, cell, pairs); });
    }

    /// Samples are half a cell apart, so that a point of a segment is within a quarter of a cell of one of them.
    template <typename Visit>
    void for_each_cell_near(const glm::dvec3& end, const Visit& visit) const
    {
        const double reach = 0.25 * cell_ + tolerance_;
        const glm::dvec3 low = glm::floor((end - reach) / cell_), high = glm::floor((end + reach) / cell_);
        for (double x = low.x; x <= high.x; ++x) {
            for (double y = low.y; y <= high.y; ++y) {
                for (double z = low.z; z <= high.z; ++z) visit(cell_key({x, y, z}));
            }
        }
    }

    void find_in_cell(std::uint32_t index, const glm::dvec3& end, std::uint64_t cell, Pairs& pairs) const
    {
        const auto found = first_.find(cell);
        if (found == first_.end()) return;
        const Segment& segment = segments_[index];
        for (std::uint32_t i = found->second; i < entries_.size() && entries_[i].cell == cell; ++i) {
            const Segment& other = segments_[entries_[i].segment];
            if (entries_[i].segment == index || other.key != segment.key) continue;
            if (distance_to(end, other) > tolerance_) continue;
            const bool is_longer = length_of(segment) > length_of(other);
            if (is_longer ? is_on_line(other, segment, tolerance_) : is_on_line(segment, other, tolerance_))
                pairs.push_back({index, entries_[i].segment});
        }
    }

    /// Short segments around a curve are pairwise on one line and yet not all: only what lies on the longest is a
    /// group.
    void split_into_lines(std::vector<std::uint32_t> members, std::vector<std::vector<std::uint32_t>>& groups)
    {
        while (members.size() > 1 && compared_ < kMostCompared) {
            compared_ += members.size();
            const std::uint32_t longest = *std::max_element(members.begin(), members.end(), [&](auto a, auto b) {
                return length_of(segments_[a]) < length_of(segments_[b]);
            });
            const auto rest = std::stable_partition(members.begin(), members.end(), [&](std::uint32_t i) {
                return is_on_line(segments_[i], segments_[longest], tolerance_);
            });
            if (rest - members.begin() > 1) groups.emplace_back(members.begin(), rest);
            members.erase(members.begin(), rest);
        }
    }

    std::span<const Segment> segments_;
    double tolerance_;
    double cell_;
    DisjointSets sets_;
    std::vector<Entry> entries_;
    std::unordered_map<std::uint64_t, std::uint32_t> first_;
    std::mutex joining_;  // guards sets_
    std::uint64_t compared_ = 0;
};

}  // namespace

std::vector<std::vector<std::uint32_t>> group_by_line(std::span<const Segment> segments, double tolerance)
{
    return LineGroups(segments, tolerance).run();
}

}  // namespace hw
