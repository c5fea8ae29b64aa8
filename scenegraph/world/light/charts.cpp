#include "hatchway/world/light/charts.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <numeric>

namespace hw {
namespace {

constexpr double kSameDirection = 0.9999985;  // cosine of 0.1 degree
constexpr double kFlatness = 1e-5;            // of the mesh's size
constexpr double kNoArea = 1e-14;             // of the square of the mesh's size

struct ChartEdge {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    std::uint32_t triangle = 0;
    auto operator<=>(const ChartEdge&) const = default;
};

/// For each vertex the first one at the same position.
std::vector<std::uint32_t> welded(const std::vector<glm::vec3>& positions)
{
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t v) { return std::array{positions[v].x, positions[v].y, positions[v].z}; };
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    std::vector<std::uint32_t> first(positions.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool is_new = i == 0 || positions[order[i]] != positions[order[i - 1]];
        first[order[i]] = is_new ? order[i] : first[order[i - 1]];
    }
    return first;
}

/// The triangles of a mesh with what growing a chart asks for.
class Triangles {
 public:
    explicit Triangles(const MeshData& mesh) : mesh_(mesh), vertex_(welded(mesh.positions))
    {
        glm::dvec3 low(1e300), high(-1e300);
        for (const glm::vec3& position : mesh.positions) {
            low = glm::min(low, glm::dvec3(position));
            high = glm::max(high, glm::dvec3(position));
        }
        size_ = mesh.positions.empty() ? 0.0 : glm::length(high - low);
        for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
            cross_.push_back(glm::cross(corner(t, 1) - corner(t, 0), corner(t, 2) - corner(t, 0)));
            for (std::uint32_t k = 0; k < 3; ++k) edges_.push_back(edge(t, k));
        }
        std::sort(edges_.begin(), edges_.end());
    }

    std::uint32_t count() const { return static_cast<std::uint32_t>(cross_.size()); }
    double area(std::uint32_t t) const { return 0.5 * glm::length(cross_[t]); }
    bool has_area(std::uint32_t t) const { return glm::length(cross_[t]) > kNoArea * size_ * size_; }
    glm::dvec3 normal(std::uint32_t t) const { return glm::normalize(cross_[t]); }
    glm::dvec3 corner(std::uint32_t t, std::uint32_t k) const { return mesh_.positions[mesh_.indices[t * 3 + k % 3]]; }

    bool fits(std::uint32_t t, const PlanarChart& chart, std::uint32_t first) const
    {
        if (has_area(t) && glm::dot(normal(t), chart.normal) < kSameDirection) return false;
        for (std::uint32_t k = 0; k < 3; ++k)
            if (std::abs(glm::dot(corner(t, k) - corner(first, 0), chart.normal)) > kFlatness * size_) return false;
        return true;
    }
    /// Calls visit(triangle) for the others at edge k of triangle t.
    template <typename Visit>
    void visit_neighbours(std::uint32_t t, std::uint32_t k, const Visit& visit) const
    {
        const ChartEdge own = edge(t, k);
        const ChartEdge least{own.low, own.high, 0};
        for (auto at = std::lower_bound(edges_.begin(), edges_.end(), least);
             at != edges_.end() && at->low == own.low && at->high == own.high; ++at)
            if (at->triangle != t) visit(at->triangle);
    }

 private:
    ChartEdge edge(std::uint32_t t, std::uint32_t k) const
    {
        const std::uint32_t a = vertex_[mesh_.indices[t * 3 + k]];
        const std::uint32_t b = vertex_[mesh_.indices[t * 3 + (k + 1) % 3]];
        return {std::min(a, b), std::max(a, b), t};
    }

    const MeshData& mesh_;
    std::vector<std::uint32_t> vertex_;
    std::vector<glm::dvec3> cross_;
    std::vector<ChartEdge> edges_;
    double size_ = 0.0;
};

constexpr std::uint32_t kNoChart = 0xffffffffu;

PlanarChart grown(const Triangles& triangles, std::uint32_t first, std::uint32_t number,
                  std::vector<std::uint32_t>& chart_of)
{
    PlanarChart chart;
    if (triangles.has_area(first)) chart.normal = triangles.normal(first);
    chart.triangles.push_back(first);
    chart_of[first] = number;
    for (std::size_t next = 0; next < chart.triangles.size(); ++next) {
        const std::uint32_t t = chart.triangles[next];
        chart.area += triangles.area(t);
        for (std::uint32_t k = 0; k < 3; ++k)
            triangles.visit_neighbours(t, k, [&](std::uint32_t other) {
                if (chart_of[other] != kNoChart || !triangles.fits(other, chart, first)) return;
                chart_of[other] = number;
                chart.triangles.push_back(other);
            });
    }
    return chart;
}

glm::dvec3 longest_outer_edge(const Triangles& triangles, const PlanarChart& chart,
                              const std::vector<std::uint32_t>& chart_of)
{
    glm::dvec3 longest(0.0);
    for (const std::uint32_t t : chart.triangles)
        for (std::uint32_t k = 0; k < 3; ++k) {
            bool is_inner = false;
            triangles.visit_neighbours(t, k, [&](std::uint32_t other) { is_inner |= chart_of[other] == chart_of[t]; });
            const glm::dvec3 way = triangles.corner(t, k + 1) - triangles.corner(t, k);
            if (!is_inner && glm::dot(way, way) > glm::dot(longest, longest)) longest = way;
        }
    return longest;
}

}  // namespace

std::vector<PlanarChart> planar_charts(const MeshData& mesh)
{
    const Triangles triangles(mesh);
    std::vector<std::uint32_t> order(triangles.count());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return triangles.area(a) > triangles.area(b); });
    std::vector<std::uint32_t> chart_of(triangles.count(), kNoChart);
    std::vector<PlanarChart> charts;
    for (const std::uint32_t t : order)
        if (chart_of[t] == kNoChart)
            charts.push_back(grown(triangles, t, static_cast<std::uint32_t>(charts.size()), chart_of));
    for (PlanarChart& chart : charts) {
        glm::dvec3 way = longest_outer_edge(triangles, chart, chart_of);
        way -= chart.normal * glm::dot(way, chart.normal);
        const glm::dvec3 any = std::abs(chart.normal.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
        if (!(glm::length(way) > 0.0)) way = glm::cross(chart.normal, any);
        chart.along = glm::normalize(way);
    }
    return charts;
}

}  // namespace hw
