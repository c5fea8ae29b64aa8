#include "hatchway/drawing/line_strokes.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numeric>
#include <tuple>

namespace hw {
namespace {

constexpr std::uint32_t kFree = 0xffffffffu;
constexpr float kTurnCosine = 0.82f;

/// Ends are numbered: twice the line, plus 1 for its second end.
class StrokeSearch {
 public:
    explicit StrokeSearch(std::span<const StrokeSegment> segments)
        : segments_(segments), next_(2 * segments.size(), kFree), strokes_(segments.size())
    {
        link_ends();
    }

    std::vector<LineStroke> run()
    {
        std::vector<bool> is_done(segments_.size(), false);
        // From free ends first; what is left then is closed.
        for (const bool is_closed : {false, true})
            for (std::uint32_t end = 0; end < next_.size(); ++end)
                if (!is_done[end / 2] && (is_closed || next_[end] == kFree)) walk(end, is_closed, is_done);
        return std::move(strokes_);
    }

 private:
    const glm::vec3& place(std::uint32_t end) const { return segments_[end / 2].ends[end % 2]; }
    glm::vec3 into_line(std::uint32_t end) const
    {
        const glm::vec3 way = place(end ^ 1u) - place(end);
        const float length = glm::length(way);
        return length > 0.0f ? way / length : glm::vec3(0.0f);
    }

    void link_ends()
    {
        const auto key = [&](std::uint32_t end) {
            const glm::vec3& p = place(end);
            return std::tuple(segments_[end / 2].line_class, p.x, p.y, p.z);
        };
        std::vector<std::uint32_t> order(next_.size());
        std::iota(order.begin(), order.end(), 0u);
        std::sort(order.begin(), order.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
        for (std::size_t first = 0; first < order.size();) {
            std::size_t end = first + 1;
            while (end < order.size() && key(order[end]) == key(order[first])) ++end;
            const std::uint32_t a = order[first], b = order[end - 1];
            if (end - first == 2 && a / 2 != b / 2 && glm::dot(into_line(a), into_line(b)) < -kTurnCosine) {
                next_[a] = b;
                next_[b] = a;
            }
            first = end;
        }
    }

    static float seed_of(const glm::vec3& p)
    {
        std::uint32_t hash = 2166136261u;
        for (const float x : {p.x, p.y, p.z}) hash = (hash ^ std::bit_cast<std::uint32_t>(x + 0.0f)) * 16777619u;
        hash ^= hash >> 15;
        return static_cast<float>(hash & 0xffffu) / 65536.0f;
    }

    void walk(std::uint32_t first, bool is_closed, std::vector<bool>& is_done)
    {
        std::vector<std::uint32_t> entries;
        float length = 0.0f;
        for (std::uint32_t end = first; end != kFree && !is_done[end / 2]; end = next_[end ^ 1u]) {
            is_done[end / 2] = true;
            LineStroke& stroke = strokes_[end / 2];
            const float after = length + glm::distance(place(end), place(end ^ 1u));
            stroke.from = end % 2 == 0 ? length : after;
            stroke.to = end % 2 == 0 ? after : length;
            entries.push_back(end / 2);
            length = after;
        }
        for (const std::uint32_t line : entries) {
            strokes_[line].length = is_closed ? -length : length;
            strokes_[line].seed = seed_of(place(first));
        }
    }

    std::span<const StrokeSegment> segments_;
    std::vector<std::uint32_t> next_;  ///< Of each end, the end that it runs on into.
    std::vector<LineStroke> strokes_;
};

}  // namespace

std::vector<LineStroke> find_strokes(std::span<const StrokeSegment> segments)
{
    return StrokeSearch(segments).run();
}

}  // namespace hw
