#include "hatchway/geometry/topology/stitch.hpp"

#include <algorithm>
#include <unordered_map>

#include "hatchway/geometry/topology/position_grid.hpp"

namespace hw {
namespace {

struct BorderEdge {
    std::uint32_t from;
    std::uint32_t to;
    bool is_joined = false;
};

class Stitcher {
 public:
    Stitcher(std::span<const glm::vec3> positions, std::vector<FaceCorners>& faces, std::span<const DirectedEdge> uses,
             float tolerance)
        : faces_(faces), grid_(positions, tolerance), tolerance_(tolerance)
    {
        for_each_edge(uses, [&](std::span<const DirectedEdge> edge) {
            if (edge.size() == 1) add_border(edge[0]);
        });
        if (borders_.empty()) return;
        std::vector<bool> is_on_border(positions.size(), false);
        for (const auto& [corner, borders] : leaving_) {
            grid_.add(corner);
            is_on_border[corner] = true;
        }
        for (std::uint32_t face = 0; face < faces.size(); ++face) {
            for (const std::uint32_t corner : faces[face]) {
                if (is_on_border[corner]) faces_at_[corner].push_back(face);
            }
        }
    }

    std::uint32_t run()
    {
        std::uint32_t joined = 0;
        for (BorderEdge& edge : borders_) {
            if (!grid_.has_steps()) break;  // the rest stay borders
            if (edge.is_joined || grid_.distance(edge.from, edge.to) <= 2.0 * tolerance_) continue;
            BorderEdge* const partner = nearest_partner(edge);
            if (!partner || !join(edge.from, partner->to) || !join(edge.to, partner->from)) continue;
            edge.is_joined = partner->is_joined = true;
            ++joined;
        }
        for (const auto& [id, root] : root_) {
            for (const std::uint32_t face : faces_at_[id]) {
                std::replace(faces_[face].begin(), faces_[face].end(), id, find(id));
            }
        }
        return joined;
    }

 private:
    void add_border(const DirectedEdge& use)
    {
        const std::uint32_t from = use.is_forward ? use.low : use.high, to = use.is_forward ? use.high : use.low;
        leaving_[from].push_back(static_cast<std::uint32_t>(borders_.size()));
        leaving_.try_emplace(to);
        borders_.push_back({from, to});
    }

    BorderEdge* nearest_partner(const BorderEdge& edge)
    {
        BorderEdge* best = nullptr;
        double best_distance = 2.0 * tolerance_;
        grid_.for_each_near(edge.to, [&](std::uint32_t start) {
            const std::vector<std::uint32_t>& leaving = leaving_.at(start);
            if (!grid_.spend(leaving.size())) return;
            for (const std::uint32_t index : leaving) {
                BorderEdge& other = borders_[index];
                if (other.is_joined || &other == &edge || grid_.distance(other.to, edge.from) > tolerance_) continue;
                const double total = grid_.distance(edge.to, other.from) + grid_.distance(edge.from, other.to);
                if (total > best_distance || (best && total == best_distance && &other > best)) continue;
                best = &other;
                best_distance = total;
            }
        });
        return best;
    }

    std::uint32_t find(std::uint32_t id) const
    {
        for (auto found = root_.find(id); found != root_.end(); found = root_.find(id)) id = found->second;
        return id;
    }

    /// Gives two positions one id, unless a face would lose a corner by it.
    bool join(std::uint32_t a, std::uint32_t b)
    {
        a = find(a);
        b = find(b);
        if (a == b) return true;
        if (b < a) std::swap(a, b);
        for (const std::uint32_t member : members(b)) {
            grid_.spend(1 + faces_at_[member].size());
            for (const std::uint32_t face : faces_at_[member]) {
                for (const std::uint32_t corner : faces_[face]) {
                    if (find(corner) == a) return false;
                }
            }
        }
        const std::vector<std::uint32_t> moved = members(b);
        members_[b].clear();
        auto& kept = members_[a];
        if (kept.empty()) kept.push_back(a);
        kept.insert(kept.end(), moved.begin(), moved.end());
        root_[b] = a;
        return true;
    }
    std::vector<std::uint32_t> members(std::uint32_t root) const
    {
        const auto found = members_.find(root);
        return found == members_.end() || found->second.empty() ? std::vector<std::uint32_t>{root} : found->second;
    }

    std::vector<FaceCorners>& faces_;
    PositionGrid grid_;
    double tolerance_;
    std::vector<BorderEdge> borders_;
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> leaving_;   // position -> borders that start there
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> faces_at_;  // position -> faces around it
    std::unordered_map<std::uint32_t, std::uint32_t> root_;
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> members_;
};

}  // namespace

std::uint32_t stitch_borders(std::span<const glm::vec3> positions, std::vector<FaceCorners>& faces,
                             std::span<const DirectedEdge> uses, float tolerance)
{
    if (!(tolerance > 0.0f)) return 0;
    return Stitcher(positions, faces, uses, tolerance).run();
}

}  // namespace hw
