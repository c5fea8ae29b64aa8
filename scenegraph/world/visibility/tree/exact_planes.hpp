#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <unordered_map>
#include <vector>

#include "hatchway/core/box.hpp"

namespace hw {

using Int128 = __int128;

/// A cubic grid of points: world = origin + step * grid point. The step is a power of two, so that grid coordinates of
/// a world position below are exact up to the subtraction of the origin.
struct Grid {
    static constexpr double kUsualStep_m = 1.0 / 131072.0;
    glm::dvec3 origin_world{0.0};
    double step_m = kUsualStep_m;

    /// A tolerance that is meant for scenes of metres; in scenes so small that their grid is finer, it shrinks with it.
    double scaled(double tolerance_m) const
    {
        return step_m < kUsualStep_m ? tolerance_m * (step_m / kUsualStep_m) : tolerance_m;
    }
};

/// Grid coordinates never leave [-kMaxGridCoordinate, kMaxGridCoordinate]: the width of every product follows from it.
inline constexpr std::int64_t kMaxGridCoordinate = std::int64_t{1} << 26;

/// The grid for `bounds_world`: centred, 2^-17 m (7.6e-6 m) fine; coarser where the scene is larger than a quarter of a
/// kilometre, finer where it is smaller than 6 cm: a scene's size alone changes no decision.
Grid grid_for(const Box& bounds_world);

/// The nearest grid point.
std::array<std::int64_t, 3> snapped(const Grid& grid, const glm::dvec3& point_world);

/// An oriented plane n.x + d = 0 over the grid, in lowest terms: |n| < 2^58, |d| < 2^87.
struct ExactPlane {
    std::array<std::int64_t, 3> normal{};
    Int128 offset = 0;
    glm::dvec3 unit_normal{0.0};  ///< Rounded from `normal`.
    double unit_offset = 0.0;     ///< Rounded, in grid units.

    /// Rounded signed distance of a point in grid units.
    double distance(const glm::dvec3& point_grid) const
    {
        return unit_normal.x * point_grid.x + unit_normal.y * point_grid.y + unit_normal.z * point_grid.z + unit_offset;
    }
};

/// The plane with these coefficients. `normal` is not zero.
ExactPlane make_plane(const std::array<std::int64_t, 3>& normal, Int128 offset);

/// A plane of the set, seen from its positive or its negative side.
struct SidePlane {
    int plane = 0;
    bool is_flipped = false;  ///< The inside is where n.x + d is negative.

    bool operator==(const SidePlane&) const = default;
};

/// All planes of a tree, each once: a plane and its reverse have the same number.
class PlaneSet {
 public:
    /// The number of the plane; is_flipped says that the stored one looks the other way.
    SidePlane add(const ExactPlane& plane);
    const ExactPlane& operator[](int plane) const { return planes_[static_cast<std::size_t>(plane)]; }
    int size() const { return static_cast<int>(planes_.size()); }

    /// The exact sign (-1, 0, +1) at `plane` of the point where a, b and c meet; `point_grid` is that point, rounded.
    /// a, b and c meet in one point.
    int sign(int plane, int a, int b, int c, const glm::dvec3& point_grid) const;

    /// Where three planes meet, rounded to a few units in the last place, grid units. They meet in one point.
    glm::dvec3 meeting_point(int a, int b, int c) const;

 private:
    std::vector<ExactPlane> planes_;
    std::unordered_multimap<std::uint64_t, int> by_hash_;
};

/// The exact sign of n.x + d at a world point, whatever its digits.
int exact_sign(const Grid& grid, const ExactPlane& plane, const glm::dvec3& point_world);

/// How often sign() had to leave the floating-point filter, by this thread: for measuring.
std::uint64_t& exact_fallback_count();

}  // namespace hw
