#include "hatchway/world/visibility/tree/large_planes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>

namespace hw {
namespace {

constexpr double kNormalCell = 1.0 / 64.0;
constexpr double kOffsetCellM = 0.1;
constexpr int kPlaceBits = 22;

constexpr std::array<double, 2> kShifts{0.0, 0.5};

}  // namespace

LargePlanes::Facet LargePlanes::facet_of(const GridTriangle& triangle) const
{
    const auto corner = [&](std::size_t i) {
        const auto& p = triangle.corners[i];
        return glm::dvec3(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])) * step_m_;
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

std::size_t LargePlanes::place(const Facet& facet, double shift)
{
    std::uint64_t hash = 0;
    for (const double place : {facet.normal.x / kNormalCell, facet.normal.y / kNormalCell, facet.normal.z / kNormalCell,
                               facet.offset_m / kOffsetCellM}) {
        const auto cell = static_cast<std::int64_t>(std::floor(place + shift));
        hash = (hash ^ static_cast<std::uint64_t>(cell)) * 0x9e3779b97f4a7c15ull;
        hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash >> (64 - kPlaceBits));
}

void LargePlanes::add_area(const GridTriangle& triangle)
{
    const Facet facet = facet_of(triangle);
    for (std::size_t i = 0; i < kShifts.size(); ++i) {
        areas_[i].resize(std::size_t{1} << kPlaceBits);
        areas_[i][place(facet, kShifts[i])] += facet.area;
    }
}

double LargePlanes::area_of(const GridTriangle& triangle) const
{
    if (triangle.is_named) return std::numeric_limits<double>::infinity();
    const Facet facet = facet_of(triangle);
    return std::max(areas_[0][place(facet, kShifts[0])], areas_[1][place(facet, kShifts[1])]);
}

void LargePlanes::rank(const GridTriangle& triangle)
{
    ranked_.push_back(area_of(triangle));
}

void LargePlanes::choose(std::size_t most)
{
    if (ranked_.size() <= most) return;
    const auto last = ranked_.begin() + static_cast<std::ptrdiff_t>(most);
    std::nth_element(ranked_.begin(), last, ranked_.end(), std::greater<>());
    least_area_ = *last;
    ranked_ = {};
}

bool LargePlanes::keeps(const GridTriangle& triangle) const
{
    return area_of(triangle) >= least_area_;
}

}  // namespace hw
