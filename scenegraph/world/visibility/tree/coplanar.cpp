#include "hatchway/world/visibility/tree/coplanar.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <unordered_map>

namespace hw {
namespace {

constexpr std::size_t kMostCorners = 32;
using Point = std::array<std::int64_t, 3>;
using FlatPoint = std::array<std::int64_t, 2>;

std::array<std::int64_t, 3> normal_of(const GridTriangle& triangle)
{
    const auto& [a, b, c] = triangle.corners;
    const Point u{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const Point v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

glm::dvec3 rounded(const Point& p)
{
    return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

ExactPlane plane_of(const GridTriangle& triangle, const Point& normal)
{
    Int128 offset = 0;
    for (std::size_t i = 0; i < 3; ++i) offset -= static_cast<Int128>(normal[i]) * triangle.corners[0][i];
    return make_plane(normal, offset);
}

/// Planes found by nearness: a coarse grid over unit normal and offset.
class PlaneFinder {
 public:
    explicit PlaneFinder(double tolerance) : tolerance_(tolerance) {}

    /// The number of a plane that all corners are near to; a new one where there is none.
    int find_or_add(const GridTriangle& triangle, const Point& normal)
    {
        const ExactPlane own = plane_of(triangle, normal);
        for (const double sign : {1.0, -1.0}) {
            const int found = find(triangle, own, sign);
            if (found >= 0) return found;
        }
        planes_.push_back(own);
        const int number = static_cast<int>(planes_.size()) - 1;
        cells_[key(cell(own.unit_normal, own.unit_offset, 0.0))].push_back(number);
        return number;
    }
    const ExactPlane& plane(int number) const { return planes_[static_cast<std::size_t>(number)]; }

 private:
    using Cell = std::array<std::int64_t, 4>;
    static constexpr double kNormalCell = 1.0 / 16.0;
    static constexpr double kOffsetCell = 65536.0;  // half a metre at the finest grid
    static constexpr std::size_t kMostTried =
        4096;                                // planes of one cell, the largest: on rough ground nearly all share one
    static constexpr double kMargin = 0.05;  // of a cell: how far a near plane's own numbers may lie away

    static Cell cell(const glm::dvec3& normal, double offset, double shift)
    {
        const auto index = [&](double value) { return static_cast<std::int64_t>(std::floor(value + shift)); };
        return {index(normal.x / kNormalCell + 0.5), index(normal.y / kNormalCell + 0.5),
                index(normal.z / kNormalCell + 0.5), index(offset / kOffsetCell + 0.5)};
    }

    static std::uint64_t key(const Cell& cell)
    {
        std::uint64_t hash = 0;
        for (const std::int64_t index : cell) hash = (hash ^ static_cast<std::uint64_t>(index)) * 0x9e3779b97f4a7c15ull;
        return hash;
    }

    bool is_near(const ExactPlane& plane, const ExactPlane& own, const GridTriangle& triangle) const
    {
        if (std::abs(glm::dot(plane.unit_normal, own.unit_normal)) < 0.9) return false;
        return std::all_of(triangle.corners.begin(), triangle.corners.end(), [&](const Point& corner) {
            return std::abs(plane.distance(rounded(corner))) <= tolerance_;
        });
    }

    int find(const GridTriangle& triangle, const ExactPlane& own, double sign) const
    {
        const Cell low = cell(sign * own.unit_normal, sign * own.unit_offset, -kMargin);
        const Cell high = cell(sign * own.unit_normal, sign * own.unit_offset, kMargin);
        for (int corner = 0; corner < 16; ++corner) {
            Cell here = low;
            bool is_new = true;
            for (int i = 0; i < 4; ++i) {
                const std::size_t axis = static_cast<std::size_t>(i);
                if ((corner >> i & 1) == 0) continue;
                is_new &= high[axis] != low[axis];
                here[axis] = high[axis];
            }
            if (!is_new) continue;
            const auto it = cells_.find(key(here));
            if (it == cells_.end()) continue;
            const std::size_t tried = std::min(it->second.size(), kMostTried);
            for (std::size_t i = 0; i < tried; ++i) {
                if (is_near(plane(it->second[i]), own, triangle)) return it->second[i];
            }
        }
        return -1;
    }

    double tolerance_;
    std::vector<ExactPlane> planes_;
    std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

/// Twice the signed area of a, b, c.
std::int64_t turn(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

double ring_area(const FlatRing& ring)
{
    double sum = 0.0;
    for (std::size_t i = 2; i < ring.size(); ++i) sum += static_cast<double>(turn(ring[0], ring[i - 1], ring[i]));
    return 0.5 * sum;
}

/// The union of two rings across side i of a and side j of b, or nothing unless it is strictly convex.
FlatRing joined(const FlatRing& a, std::size_t i, const FlatRing& b, std::size_t j)
{
    FlatRing ring;
    for (std::size_t k = 1; k <= a.size(); ++k) ring.push_back(a[(i + k) % a.size()]);
    for (std::size_t k = 2; k < b.size(); ++k) ring.push_back(b[(j + k) % b.size()]);
    FlatRing result;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const std::int64_t bend = turn(ring[(k + ring.size() - 1) % ring.size()], ring[k], ring[(k + 1) % ring.size()]);
        if (bend < 0) return {};
        if (bend > 0) result.push_back(ring[k]);
    }
    return result.size() > kMostCorners ? FlatRing{} : result;
}

/// Merges the rings of one plane in place; rings that were merged away are left empty.
class RingMerger {
 public:
    explicit RingMerger(std::vector<FlatRing>& rings) : rings_(rings)
    {
        for (std::size_t i = 0; i < rings_.size(); ++i) index_sides(i);
    }

    void merge_all()
    {
        for (std::size_t i = 0; i < rings_.size(); ++i) {
            while (!rings_[i].empty() && merge_one(i)) {
            }
        }
    }

 private:
    using Side = std::array<std::int64_t, 4>;

    void index_sides(std::size_t ring)
    {
        const FlatRing& points = rings_[ring];
        for (std::size_t i = 0; i < points.size(); ++i) {
            const FlatPoint &a = points[i], &b = points[(i + 1) % points.size()];
            ring_of_side_[{a[0], a[1], b[0], b[1]}] = ring;
        }
    }

    bool merge_one(std::size_t ring)
    {
        for (std::size_t i = 0; i < rings_[ring].size(); ++i) {
            const FlatPoint a = rings_[ring][i];
            const FlatPoint b = rings_[ring][(i + 1) % rings_[ring].size()];
            const auto it = ring_of_side_.find({b[0], b[1], a[0], a[1]});
            if (it == ring_of_side_.end() || it->second == ring) continue;
            const FlatRing& other = rings_[it->second];
            const auto start = std::find(other.begin(), other.end(), b);
            if (start == other.end()) continue;  // that ring has changed since
            const std::size_t j = static_cast<std::size_t>(start - other.begin());
            if (other[(j + 1) % other.size()] != a) continue;
            FlatRing both = joined(rings_[ring], i, other, j);
            if (both.empty()) continue;
            rings_[it->second].clear();
            rings_[ring] = std::move(both);
            index_sides(ring);
            return true;
        }
        return false;
    }

    std::vector<FlatRing>& rings_;
    std::map<Side, std::size_t> ring_of_side_;
};

struct GroupKey {
    int plane = 0;
    bool front = false;
    bool back = false;
    bool is_named = false;
    auto operator<=>(const GroupKey&) const = default;
};

FlatRing flat_ring(const GridTriangle& triangle, int axis)
{
    const std::size_t u = static_cast<std::size_t>((axis + 1) % 3);
    const std::size_t v = static_cast<std::size_t>((axis + 2) % 3);
    FlatRing ring;
    for (const Point& corner : triangle.corners) ring.push_back({corner[u], corner[v]});
    const std::int64_t bend = turn(ring[0], ring[1], ring[2]);
    if (bend == 0) return {};
    if (bend < 0) std::swap(ring[1], ring[2]);
    return ring;
}

std::map<GroupKey, std::vector<FlatRing>> group(std::span<const GridTriangle> triangles, PlaneFinder& finder)
{
    struct Sized {
        double squared_area;
        std::size_t index;
    };
    std::vector<Sized> order;
    std::vector<Point> normals(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        normals[i] = normal_of(triangles[i]);
        if (normals[i] != Point{}) order.push_back({glm::dot(rounded(normals[i]), rounded(normals[i])), i});
    }
    std::stable_sort(order.begin(), order.end(),
                     [](const Sized& a, const Sized& b) { return a.squared_area > b.squared_area; });
    std::map<GroupKey, std::vector<FlatRing>> groups;
    for (const Sized& entry : order) {
        const GridTriangle& triangle = triangles[entry.index];
        const int number = finder.find_or_add(triangle, normals[entry.index]);
        const ExactPlane& plane = finder.plane(number);
        FlatRing ring = flat_ring(triangle, major_axis(plane));
        if (ring.empty()) continue;
        const bool looks_front = glm::dot(rounded(normals[entry.index]), plane.unit_normal) > 0.0;
        const bool both = triangle.is_double_sided;
        groups[{number, looks_front || both, !looks_front || both, triangle.is_named}].push_back(std::move(ring));
    }
    return groups;
}

}  // namespace

std::vector<FlatPolygon> merge_coplanar(std::span<const GridTriangle> triangles, double tolerance)
{
    PlaneFinder finder(tolerance);
    std::vector<FlatPolygon> result;
    for (auto& [key, rings] : group(triangles, finder)) {
        RingMerger(rings).merge_all();
        const ExactPlane& plane = finder.plane(key.plane);
        const double shrink = std::abs(plane.unit_normal[major_axis(plane)]);
        for (FlatRing& ring : rings) {
            if (ring.empty()) continue;
            const double ring_size = ring_area(ring) / shrink;
            result.push_back({plane, std::move(ring), key.front, key.back, key.is_named, ring_size});
        }
    }
    return result;
}

}  // namespace hw
