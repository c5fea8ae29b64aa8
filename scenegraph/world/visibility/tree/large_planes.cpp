#include "hatchway/world/visibility/tree/large_planes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <unordered_map>

namespace hw {
namespace {

constexpr double kNormalCell = 1.0 / 64.0;
constexpr double kOffsetCellM = 0.1;

struct Facet {
    glm::dvec3 normal{0.0};  ///< Unit, its largest component positive: a plane has two sides.
    double offset_m = 0.0;
    double area = 0.0;
};

Facet facet_of(const GridTriangle& triangle, double step_m)
{
    const auto corner = [&](std::size_t i) {
        const auto& p = triangle.corners[i];
        return glm::dvec3(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])) * step_m;
    };
    const glm::dvec3 a = corner(0);
    const glm::dvec3 cross = glm::cross(corner(1) - a, corner(2) - a);
    const double length = glm::length(cross);
    if (!(length > 0.0)) return {};
    glm::dvec3 normal = cross / length;
    const glm::dvec3 size = glm::abs(normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    if (normal[axis] < 0.0) normal = -normal;
    return {normal, -glm::dot(normal, a), 0.5 * length};
}

/// Facets by cells; `shift` of a cell, since mates may lie on either side of a border.
class AreaOfCells {
 public:
    explicit AreaOfCells(double shift) : shift_(shift) {}
    void add(const Facet& facet) { areas_[key(facet)] += facet.area; }
    double area(const Facet& facet) const { return areas_.at(key(facet)); }

 private:
    std::uint64_t key(const Facet& facet) const
    {
        std::uint64_t hash = 0;
        for (const double place : {facet.normal.x / kNormalCell, facet.normal.y / kNormalCell,
                                   facet.normal.z / kNormalCell, facet.offset_m / kOffsetCellM}) {
            const auto cell = static_cast<std::int64_t>(std::floor(place + shift_));
            hash = (hash ^ static_cast<std::uint64_t>(cell)) * 0x9e3779b97f4a7c15ull;
            hash ^= hash >> 29;
        }
        return hash;
    }

    double shift_;
    std::unordered_map<std::uint64_t, double> areas_;
};

}  // namespace

std::size_t keep_in_large_planes(std::vector<GridTriangle>& triangles, std::size_t most, double step_m)
{
    if (triangles.size() <= most) return 0;
    AreaOfCells cells(0.0), between(0.5);
    for (const GridTriangle& triangle : triangles) {
        const Facet facet = facet_of(triangle, step_m);
        cells.add(facet);
        between.add(facet);
    }
    std::vector<double> area;
    for (const GridTriangle& triangle : triangles) {
        const Facet facet = facet_of(triangle, step_m);
        area.push_back(triangle.is_named ? std::numeric_limits<double>::infinity()
                                         : std::max(cells.area(facet), between.area(facet)));
    }
    std::vector<double> sorted = area;
    const auto last = sorted.begin() + static_cast<std::ptrdiff_t>(most);
    std::nth_element(sorted.begin(), last, sorted.end(), std::greater<>());
    std::size_t kept = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (area[i] >= *last) triangles[kept++] = triangles[i];
    }
    const std::size_t left_out = triangles.size() - kept;
    triangles.resize(kept);
    return left_out;
}

}  // namespace hw
