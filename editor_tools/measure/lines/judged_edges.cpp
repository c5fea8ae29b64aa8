#include "measure/lines/judged_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <numeric>
#include <set>

namespace hw {
namespace {

const double kLeastMeantFold = std::cos(0.035);  // below, split normals are noise
const double kSharpFold = std::cos(1.05);        // above, folds are split in any shading
constexpr double kSplitCosine = 0.9994;
constexpr double kAllOf = 0.95;
constexpr double kThin = 1e-3;  // of its longest side: which way such a triangle looks, its rounded corners do not tell

using Place = std::array<float, 3>;
using Ends = std::pair<Place, Place>;

/// A triangle at one of its edges.
struct Side {
    glm::dvec3 normal;  ///< World space, as long as twice the area.
    bool is_forward;
    std::size_t triangle;
    bool is_thin;
    std::array<glm::vec3, 2> stated;  ///< The model's own normals at the edge's ends; 0 where it has none.
};

Place place_of(const glm::vec3& p)
{
    return {p.x, p.y, p.z};
}

/// Pieces of a mesh that hang together by edges of two triangles.
class Pieces {
 public:
    explicit Pieces(std::size_t count) : root_(count) { std::iota(root_.begin(), root_.end(), std::size_t{0}); }
    std::size_t of(std::size_t i)
    {
        while (root_[i] != i) i = root_[i] = root_[root_[i]];
        return i;
    }
    void join(std::size_t a, std::size_t b) { root_[of(a)] = of(b); }

 private:
    std::vector<std::size_t> root_;
};

class EdgeSearch {
 public:
    EdgeSearch(const Scene& scene, ObjectId id)
        : mesh_(scene.meshes[static_cast<std::size_t>(scene.objects[id].mesh)]),
          world_(scene.world_from_object(id)),
          turn_(glm::determinant(glm::dmat3(world_)) < 0.0 ? -1.0 : 1.0),
          pieces_(mesh_.triangle_count())
    {
        for (std::size_t triangle = 0; triangle < mesh_.triangle_count(); ++triangle) add_triangle(triangle);
        for (const auto& [ends, around] : sides_)
            if (around.size() == 2) pieces_.join(around[0].triangle, around[1].triangle);
        find_meant();
    }

    std::vector<JudgedEdge> run(double crease_cosine)
    {
        std::vector<JudgedEdge> edges;
        for (const auto& [ends, around] : sides_) edges.push_back(edge_of(ends, around, crease_cosine));
        return edges;
    }

 private:
    glm::dvec3 in_world(const Place& p) const { return glm::dvec3(world_ * glm::dvec4(p[0], p[1], p[2], 1.0)); }

    void add_triangle(std::size_t triangle)
    {
        const std::uint32_t* const index = &mesh_.indices[3 * triangle];
        std::array<Place, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) corners[k] = place_of(mesh_.positions[index[k]]);
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) return;
        const glm::dvec3 a = in_world(corners[0]), b = in_world(corners[1]), c = in_world(corners[2]);
        const glm::dvec3 normal = turn_ * glm::cross(b - a, c - a);
        const double longest_m = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
        const bool is_thin = glm::length(normal) <= kThin * longest_m * longest_m;
        const bool has_stated = mesh_.has_own_normals && !mesh_.normals.empty();
        const auto stated = [&](std::size_t k) { return has_stated ? mesh_.normals[index[k]] : glm::vec3(0.0f); };
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            const bool is_forward = corners[k] < corners[next];
            Side side{normal, is_forward, triangle, is_thin, {stated(k), stated(next)}};
            if (!is_forward) std::swap(side.stated[0], side.stated[1]);
            sides_[std::minmax(corners[k], corners[next])].push_back(side);
        }
    }

    /// Of two faces, as if they were wound alike: two that go along the edge the same way are wound against each other.
    static double fold_cosine(const std::vector<Side>& around)
    {
        const double size = glm::length(around[0].normal) * glm::length(around[1].normal);
        const double turn = around[0].is_forward == around[1].is_forward ? -1.0 : 1.0;
        return size > 0.0 ? turn * glm::dot(around[0].normal, around[1].normal) / size : 1.0;
    }

    static bool is_split(const std::vector<Side>& around)
    {
        for (std::size_t end = 0; end < 2; ++end) {
            const glm::dvec3 a = around[0].stated[end], b = around[1].stated[end];
            if (a == glm::dvec3(0.0) || b == glm::dvec3(0.0) || glm::dot(a, b) >= kSplitCosine) return false;
        }
        return true;
    }

    void find_meant()
    {
        for (std::size_t i = 0; i + 1 < mesh_.artist_edges.size(); i += 2)
            meant_.insert(std::minmax(place_of(mesh_.positions[mesh_.artist_edges[i]]),
                                      place_of(mesh_.positions[mesh_.artist_edges[i + 1]])));
        struct Folds {
            std::size_t all = 0, split = 0;
            bool are_shaded_flat() const { return static_cast<double>(split) >= kAllOf * static_cast<double>(all); }
        };
        std::map<std::size_t, Folds> folds;
        std::vector<std::pair<Ends, std::size_t>> split;
        for (const auto& [ends, around] : sides_) {
            if (around.size() != 2 || fold_cosine(around) >= kLeastMeantFold) continue;
            const std::size_t piece = pieces_.of(around[0].triangle);
            if (is_split(around)) split.emplace_back(ends, piece);
            if (fold_cosine(around) < kSharpFold) continue;
            ++folds[piece].all;
            folds[piece].split += is_split(around) ? 1 : 0;
        }
        for (const auto& [ends, piece] : split)
            if (!folds[piece].are_shaded_flat()) meant_.insert(ends);
    }

    JudgedEdge edge_of(const Ends& ends, const std::vector<Side>& around, double crease_cosine) const
    {
        JudgedEdge edge{.from = in_world(ends.first), .to = in_world(ends.second), .normals = {}};
        for (const Side& side : around)
            edge.normals.push_back(
                side.is_forward == around.front().is_forward && &side != &around.front() ? -side.normal : side.normal);
        edge.is_sure = around.size() <= 2;
        if (around.size() == 2) {
            edge.is_crease = fold_cosine(around) < crease_cosine;
            edge.is_sure = !around[0].is_thin && !around[1].is_thin;
        }
        edge.is_crease = edge.is_crease || !edge.is_sure || meant_.contains(ends);
        return edge;
    }

    const MeshData& mesh_;
    const glm::dmat4& world_;
    double turn_;
    Pieces pieces_;
    std::map<Ends, std::vector<Side>> sides_;
    std::set<Ends> meant_;
};

}  // namespace

std::vector<JudgedEdge> judged_edges(const Scene& scene, ObjectId id, double crease_rad)
{
    std::vector<JudgedEdge> edges = EdgeSearch(scene, id).run(std::cos(crease_rad));
    const bool is_culled = !scene.materials[static_cast<std::size_t>(scene.objects[id].material)].is_double_sided;
    for (JudgedEdge& edge : edges) edge.is_culled = is_culled;
    return edges;
}

}  // namespace hw
