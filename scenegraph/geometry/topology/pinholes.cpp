#include "hatchway/geometry/topology/pinholes.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <unordered_map>

#include "hatchway/core/box.hpp"
#include "hatchway/core/disjoint_sets.hpp"

namespace hw {
namespace {

constexpr double kRounding = 0x1p-22;  // of the largest coordinate: floats tell no smaller hole
constexpr double kMostOfPiece = 0.01;  // wider than that it is part of the piece's shape

class PinholeSearch {
 public:
    PinholeSearch(std::span<const glm::vec3> positions, std::vector<FaceCorners>& faces,
                  std::span<const DirectedEdge> uses, float share)
        : positions_(positions), faces_(faces), share_(share), pieces_(positions.size()), holes_(positions.size())
    {
        Box all;
        for (const glm::vec3& p : positions) all.add(glm::dvec3(p));
        if (all.is_empty()) return;
        const glm::dvec3 farthest = glm::max(glm::abs(all.min), glm::abs(all.max));
        rounding_ = kRounding * std::max({farthest.x, farthest.y, farthest.z});
        const double longest = std::max(share * glm::length(all.size()), rounding_);
        for_each_edge(uses, [&](std::span<const DirectedEdge> edge) {
            if (edge.size() == 1 && distance(edge[0].low, edge[0].high) <= longest)
                borders_.push_back({edge[0].low, edge[0].high});
        });
    }

    std::uint32_t run()
    {
        if (borders_.empty()) return 0;
        measure_pieces();
        std::uint32_t closed = 0;
        for (const auto& [root, corners] : holes()) {
            if (!is_small(corners) || !stays_a_surface(corners)) continue;
            for (const std::uint32_t corner : corners)
                for (const std::uint32_t face : faces_at_[corner])
                    std::replace(faces_[face].begin(), faces_[face].end(), corner, root);
            ++closed;
        }
        return closed;
    }

 private:
    using Corners = std::set<std::uint32_t>;

    double distance(std::uint32_t a, std::uint32_t b) const
    {
        return glm::distance(glm::dvec3(positions_[a]), glm::dvec3(positions_[b]));
    }

    void measure_pieces()
    {
        for (const FaceCorners& face : faces_)
            for (int i = 0; i < 2; ++i) pieces_.join(face[i], face[i + 1]);
        for (const FaceCorners& face : faces_) piece_box_[pieces_.of(face[0])].add(box_of(face));
        for (const auto& [a, b] : borders_) faces_at_[a], faces_at_[b];
        for (std::uint32_t face = 0; face < faces_.size(); ++face)
            for (const std::uint32_t corner : faces_[face])
                if (const auto at = faces_at_.find(corner); at != faces_at_.end()) at->second.push_back(face);
    }
    template <typename Some>
    Box box_of(const Some& corners) const
    {
        Box box;
        for (const std::uint32_t corner : corners) box.add(glm::dvec3(positions_[corner]));
        return box;
    }

    /// Short borders that hang together, by their smallest corner; only those that are closed.
    std::map<std::uint32_t, Corners> holes()
    {
        std::unordered_map<std::uint32_t, int> ends;
        for (const auto& [a, b] : borders_) {
            holes_.join(a, b);
            ++ends[a], ++ends[b];
        }
        std::map<std::uint32_t, Corners> found;
        for (const auto& [corner, count] : ends) found[holes_.of(corner)].insert(corner);
        std::erase_if(found, [&](const auto& hole) {
            return std::any_of(hole.second.begin(), hole.second.end(), [&](auto corner) { return ends[corner] % 2; });
        });
        return found;
    }

    bool is_small(const Corners& corners)
    {
        const double piece = glm::length(piece_box_.at(pieces_.of(*corners.begin())).size());
        return glm::length(box_of(corners).size()) <=
               std::min(std::max(share_ * piece, rounding_), kMostOfPiece * piece);
    }

    bool stays_a_surface(const Corners& corners) const
    {
        std::map<std::uint32_t, int> faces_on_edge;  // from the point to a corner
        std::set<FaceCorners> around;
        for (const std::uint32_t corner : corners)
            for (const std::uint32_t face : faces_at_.at(corner)) {
                FaceCorners kept = faces_[face];
                const auto is_at_hole = [&](std::uint32_t id) { return corners.contains(id); };
                const auto at_hole = std::count_if(kept.begin(), kept.end(), is_at_hole);
                if (at_hole == 3) return false;
                if (at_hole == 2) continue;
                std::replace_if(kept.begin(), kept.end(), is_at_hole, *corners.begin());
                std::sort(kept.begin(), kept.end());
                if (!around.insert(kept).second) return false;
                for (const std::uint32_t id : kept)
                    if (!is_at_hole(id) && ++faces_on_edge[id] > 2) return false;
            }
        return !around.empty();
    }

    std::span<const glm::vec3> positions_;
    std::vector<FaceCorners>& faces_;
    double share_;
    double rounding_ = 0.0;                              // of a coordinate
    std::vector<std::array<std::uint32_t, 2>> borders_;  // no longer than a hole may be wide
    DisjointSets pieces_;
    DisjointSets holes_;
    std::unordered_map<std::uint32_t, Box> piece_box_;
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> faces_at_;  // of corners at short borders
};

}  // namespace

std::uint32_t close_pinholes(std::span<const glm::vec3> positions, std::vector<FaceCorners>& faces,
                             std::span<const DirectedEdge> uses, float share)
{
    return share > 0.0f ? PinholeSearch(positions, faces, uses, share).run() : 0;
}

}  // namespace hw
