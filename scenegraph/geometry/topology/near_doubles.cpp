#include "hatchway/geometry/topology/near_doubles.hpp"

#include <algorithm>

#include "hatchway/core/disjoint_sets.hpp"
#include "hatchway/geometry/topology/doubled_patches.hpp"
#include "hatchway/geometry/topology/position_grid.hpp"

namespace hw {
namespace {

constexpr double kFoldedBack = 0.9;  // cosine between two faces across the border on which both lie

class NearDoubles {
 public:
    NearDoubles(std::span<const glm::vec3> positions, std::vector<FaceCorners>& faces,
                std::span<const DirectedEdge> uses, std::span<const std::uint32_t> face_triangle, float tolerance)
        : positions_(positions), faces_(faces), uses_(uses), face_triangle_(face_triangle), tolerance_(tolerance)
    {
    }

    bool run()
    {
        const std::vector<std::uint32_t> starts = on_other_borders();
        if (starts.empty()) return false;
        const std::vector<std::uint32_t> together = near_ones(candidates(starts));
        if (together.empty()) return false;
        std::vector<FaceCorners> tried = faces_;
        for (FaceCorners& face : tried) {
            for (std::uint32_t& corner : face) corner = together[corner];
            if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) return false;
        }
        const std::vector<bool> is_of_doubled = corners_of_doubled(tried);
        std::vector<FaceCorners> joined = faces_;
        for (FaceCorners& face : joined)
            for (std::uint32_t& corner : face)
                if (is_of_doubled[together[corner]]) corner = together[corner];
        if (joined == faces_ || complex_edges(joined) > complex_edges(faces_)) return false;
        faces_ = std::move(joined);
        return true;
    }

 private:
    glm::dvec3 place(std::uint32_t position) const { return glm::dvec3(positions_[position]); }

    /// From the edge to the third corner, across.
    glm::dvec3 across(const DirectedEdge& use) const
    {
        const glm::dvec3 from = place(use.low), along = place(use.high) - from;
        const glm::dvec3 apex = place(faces_[use.face][(use.corner + 2) % 3]) - from;
        const glm::dvec3 direction = apex - glm::dot(apex, along) / glm::dot(along, along) * along;
        const double length = glm::length(direction);
        return length > 0.0 ? direction / length : direction;
    }

    bool is_short(const DirectedEdge& use) const
    {
        return glm::distance(place(use.low), place(use.high)) <= 2.0 * tolerance_;
    }

    /// A position of every border that lies on another with both faces on one side; none where too many are near.
    std::vector<std::uint32_t> on_other_borders() const
    {
        std::vector<DirectedEdge> borders;
        for_each_edge(uses_, [&](std::span<const DirectedEdge> edge) {
            if (edge.size() == 1) borders.push_back(edge[0]);
        });
        PositionGrid grid(positions_, tolerance_);
        std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> at;
        for (std::uint32_t i = 0; i < borders.size(); ++i)
            for (const std::uint32_t end : {borders[i].low, borders[i].high}) {
                if (!at.contains(end)) grid.add(end);
                at[end].push_back(i);
            }
        std::vector<std::uint32_t> starts;
        for (std::uint32_t i = 0; i < borders.size(); ++i) {
            const DirectedEdge& border = borders[i];
            if (is_short(border)) continue;  // what is connected with it is left alone
            bool is_on_other = false;
            const auto lies_on = [&](const DirectedEdge& other, std::uint32_t low) {
                const std::uint32_t high = other.low == low ? other.high : other.low;
                return grid.distance(border.high, high) <= tolerance_ &&
                       glm::dot(across(border), across(other)) > kFoldedBack;
            };
            grid.for_each_near(border.low, [&](std::uint32_t low) {
                const std::vector<std::uint32_t>& others = at.at(low);
                if (is_on_other || !grid.spend(others.size())) return;
                is_on_other = std::any_of(others.begin(), others.end(), [&](std::uint32_t other) {
                    return other != i && lies_on(borders[other], low);
                });
            });
            if (is_on_other) starts.push_back(border.low);
        }
        if (!grid.has_steps()) starts.clear();
        return starts;
    }

    /// The positions of all that is connected with `starts` and has no short edge.
    std::vector<std::uint32_t> candidates(const std::vector<std::uint32_t>& starts) const
    {
        DisjointSets connected(positions_.size());
        for (const auto& [a, b, c] : faces_) {
            connected.join(a, b);
            connected.join(b, c);
        }
        std::vector<bool> is_wanted(positions_.size(), false), is_used(positions_.size(), false);
        for (const std::uint32_t start : starts) is_wanted[connected.of(start)] = true;
        for (const DirectedEdge& use : uses_) {
            is_used[use.low] = is_used[use.high] = true;
            if (is_short(use)) is_wanted[connected.of(use.low)] = false;
        }
        std::vector<std::uint32_t> result;
        for (std::uint32_t id = 0; id < positions_.size(); ++id)
            if (is_used[id] && is_wanted[connected.of(id)]) result.push_back(id);
        return result;
    }

    /// Of each position the first that is near, or itself; nothing where too many are near.
    std::vector<std::uint32_t> near_ones(const std::vector<std::uint32_t>& candidates) const
    {
        PositionGrid grid(positions_, tolerance_);
        DisjointSets groups(positions_.size());
        for (const std::uint32_t id : candidates) {
            grid.for_each_near(id, [&](std::uint32_t other) { groups.join(id, other); });
            grid.add(id);
        }
        if (!grid.has_steps()) return {};
        std::vector<std::uint32_t> result(positions_.size());
        for (std::uint32_t id = 0; id < result.size(); ++id) result[id] = groups.of(id);
        return result;
    }

    /// Of three faces or more, when those are left out that are doubled.
    std::size_t complex_edges(const std::vector<FaceCorners>& faces) const
    {
        std::vector<DirectedEdge> uses = sorted_directed_edges(faces);
        const auto leave_out = [&](const DoubledFaces& doubled) {
            if (doubled.is_dropped.empty()) return;
            std::erase_if(uses, [&](const DirectedEdge& use) { return doubled.is_dropped[use.face]; });
        };
        leave_out(find_doubled_faces(faces, uses, face_triangle_));
        leave_out(find_doubled_patches(positions_, faces, uses, face_triangle_, tolerance_));
        std::size_t count = 0;
        for_each_edge(uses, [&](std::span<const DirectedEdge> edge) { count += edge.size() > 2; });
        return count;
    }

    std::vector<bool> corners_of_doubled(const std::vector<FaceCorners>& tried) const
    {
        std::vector<bool> result(positions_.size(), false);
        const std::vector<DirectedEdge> uses = sorted_directed_edges(tried);
        for (const DoubledFaces& doubled : {find_doubled_faces(tried, uses, face_triangle_),
                                            find_doubled_patches(positions_, tried, uses, face_triangle_, tolerance_)})
            for (std::size_t face = 0; face < doubled.is_dropped.size(); ++face)
                if (doubled.is_dropped[face])
                    for (const std::uint32_t corner : tried[face]) result[corner] = true;
        return result;
    }

    std::span<const glm::vec3> positions_;
    std::vector<FaceCorners>& faces_;
    std::span<const DirectedEdge> uses_;
    std::span<const std::uint32_t> face_triangle_;
    float tolerance_;
};

}  // namespace

bool join_near_doubles(std::span<const glm::vec3> positions, std::vector<FaceCorners>& faces,
                       std::span<const DirectedEdge> uses, std::span<const std::uint32_t> face_triangle,
                       float tolerance)
{
    if (!(tolerance > 0.0f)) return false;
    return NearDoubles(positions, faces, uses, face_triangle, tolerance).run();
}

}  // namespace hw
