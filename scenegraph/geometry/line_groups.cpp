// A line is known by its direction and its point closest to the middle of all segments. Both are rounded to cells; a value
// close to a cell's wall enters the cells on both sides, so that equal lines always share one.
#include "geometry/line_groups.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "core/box.hpp"
#include "core/hash.hpp"

namespace hw {
namespace {

constexpr double kDirectionCell = 0.02;
constexpr double kDirectionMargin = 0.002;
constexpr double kDriftPerLength = 1e-6;  // lines of rounded ends turn a little

struct Line {
    glm::dvec3 direction;
    glm::dvec3 foot;  // closest to the origin of the grouping
};

Line line_of(const Segment& segment, const glm::dvec3& origin)
{
    glm::dvec3 direction = glm::normalize(segment.to - segment.from);
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(direction[axis]) < 0.3) continue;
        if (direction[axis] < 0.0) direction = -direction;
        break;
    }
    const glm::dvec3 from = segment.from - origin;
    return {direction, from - glm::dot(from, direction) * direction};
}

struct Choices {
    std::array<std::int64_t, 2> cells;
    int count;
};

Choices cells_near(double value, double cell, double margin)
{
    const auto low = static_cast<std::int64_t>(std::floor((value - margin) / cell));
    const auto high = static_cast<std::int64_t>(std::floor((value + margin) / cell));
    return {{low, high}, low == high ? 1 : 2};
}

template <typename Visit>
void for_each_cell(const Line& line, std::uint32_t key, double tolerance, Visit&& visit)
{
    const double cell = 32.0 * tolerance;
    std::array<Choices, 6> choices;
    for (int axis = 0; axis < 3; ++axis) {
        choices[axis] = cells_near(line.direction[axis], kDirectionCell, kDirectionMargin);
        choices[3 + axis] = cells_near(line.foot[axis], cell, 4.0 * tolerance);
    }
    for (unsigned pick = 0; pick < 64; ++pick) {
        std::array<std::int64_t, 7> cells{};
        bool is_choice = true;
        for (int i = 0; i < 6; ++i) {
            const int which = pick >> i & 1;
            is_choice = is_choice && which < choices[i].count;
            cells[i] = choices[i].cells[which];
        }
        cells[6] = key;
        if (is_choice) visit(hash_bytes(std::as_bytes(std::span(cells))));
    }
}

bool is_on_line(const Segment& segment, const Segment& other, double tolerance)
{
    const glm::dvec3 direction = glm::normalize(other.to - other.from);
    for (const glm::dvec3& end : {segment.from, segment.to}) {
        const glm::dvec3 offset = end - other.from;
        const double along = glm::dot(offset, direction);
        if (glm::length(offset - along * direction) > tolerance + kDriftPerLength * std::abs(along)) return false;
    }
    return true;
}

class LineGroups {
 public:
    LineGroups(std::span<const Segment> segments, double tolerance) : segments_(segments), tolerance_(tolerance)
    {
        Box box;
        for (const Segment& segment : segments) {
            box.add(segment.from);
            box.add(segment.to);
        }
        origin_ = segments.empty() ? glm::dvec3(0.0) : box.centre();
        root_.resize(segments.size());
        for (std::uint32_t i = 0; i < segments.size(); ++i) root_[i] = i;
    }

    std::vector<std::vector<std::uint32_t>> run()
    {
        for (std::uint32_t i = 0; i < segments_.size(); ++i) {
            if (glm::distance(segments_[i].from, segments_[i].to) > tolerance_) add(i);
        }
        std::vector<std::vector<std::uint32_t>> by_root(segments_.size());
        for (std::uint32_t i = 0; i < segments_.size(); ++i) by_root[find(i)].push_back(i);
        std::erase_if(by_root, [](const auto& group) { return group.size() < 2; });
        return by_root;
    }

 private:
    void add(std::uint32_t index)
    {
        const Segment& segment = segments_[index];
        for_each_cell(line_of(segment, origin_), segment.key, tolerance_, [&](std::uint64_t cell) {
            std::vector<std::uint32_t>& lines = lines_in_[cell];
            for (const std::uint32_t other : lines) {
                if (segments_[other].key != segment.key || !is_on_line(segment, segments_[other], tolerance_)) continue;
                join(index, other);
                return;
            }
            lines.push_back(index);
        });
    }
    std::uint32_t find(std::uint32_t index)
    {
        while (root_[index] != index) index = root_[index] = root_[root_[index]];
        return index;
    }
    void join(std::uint32_t a, std::uint32_t b)
    {
        a = find(a);
        b = find(b);
        if (a < b) std::swap(a, b);
        root_[a] = b;
    }

    std::span<const Segment> segments_;
    double tolerance_;
    glm::dvec3 origin_;
    std::vector<std::uint32_t> root_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> lines_in_;
};

}  // namespace

std::vector<std::vector<std::uint32_t>> group_by_line(std::span<const Segment> segments, double tolerance)
{
    return LineGroups(segments, tolerance).run();
}

}  // namespace hw
