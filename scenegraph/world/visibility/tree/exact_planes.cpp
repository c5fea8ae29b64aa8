// Why the filter bound holds: corners are clipped to the box of the tree, |x| <= 2^27 for each coordinate and rounded
// to 2^-25; a unit normal is rounded to 2^-52 and an offset of at most 2^29 to 2^-23. The rounded distance is therefore
// off by less than 2^-20, and kSureDistance leaves a factor of four.
#include "hatchway/world/visibility/tree/exact_planes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "hatchway/core/error.hpp"
#include "hatchway/world/visibility/tree/wide_int.hpp"

namespace hw {
namespace {

constexpr double kLeastSteps = 8192.0;            // that a scene is long
constexpr double kLeastReach = 1e-30;             // metres
constexpr double kSureDistance = 1.0 / 262144.0;  // 2^-18 of a grid step

using Normal = std::array<std::int64_t, 3>;

Int128 product(std::int64_t a, std::int64_t b)
{
    return static_cast<Int128>(a) * b;
}

std::array<Int128, 3> cross(const Normal& a, const Normal& b)
{
    return {product(a[1], b[2]) - product(a[2], b[1]), product(a[2], b[0]) - product(a[0], b[2]),
            product(a[0], b[1]) - product(a[1], b[0])};
}

WideInt determinant(const Normal& a, const Normal& b, const Normal& c)
{
    const std::array<Int128, 3> bc = cross(b, c);
    return WideInt(bc[0]) * WideInt(a[0]) + WideInt(bc[1]) * WideInt(a[1]) + WideInt(bc[2]) * WideInt(a[2]);
}

Int128 greatest_divisor(Int128 a, Int128 b)
{
    a = a < 0 ? -a : a;
    b = b < 0 ? -b : b;
    while (b != 0) {
        const Int128 rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

std::uint64_t hash_of(const Normal& normal, Int128 offset)
{
    std::uint64_t hash = 0xcbf29ce484222325ull;
    const auto mix = [&](std::uint64_t word) { hash = (hash ^ word) * 0x9e3779b97f4a7c15ull + (hash >> 29); };
    for (const std::int64_t n : normal) mix(static_cast<std::uint64_t>(n));
    mix(static_cast<std::uint64_t>(offset));
    mix(static_cast<std::uint64_t>(offset >> 64));
    return hash;
}

bool looks_forward(const Normal& normal)
{
    for (const std::int64_t n : normal) {
        if (n != 0) return n > 0;
    }
    return true;
}

double to_double(Int128 value)
{
    return static_cast<double>(value);
}

}  // namespace

Grid grid_for(const Box& bounds_world)
{
    Grid grid;
    if (bounds_world.is_empty()) return grid;
    const glm::dvec3 size = bounds_world.size();
    const double reach = std::max({size.x, size.y, size.z, kLeastReach});
    while (reach < grid.step_m * kLeastSteps) grid.step_m /= 2.0;
    // A quarter of the range: the tree's box is larger than the scene.
    while (reach > grid.step_m * static_cast<double>(kMaxGridCoordinate) / 4.0) grid.step_m *= 2.0;
    const glm::dvec3 centre = bounds_world.centre();
    for (int axis = 0; axis < 3; ++axis) {
        grid.origin_world[axis] = std::round(centre[axis] / (1024.0 * grid.step_m)) * 1024.0 * grid.step_m;
    }
    return grid;
}

std::array<std::int64_t, 3> snapped(const Grid& grid, const glm::dvec3& point_world)
{
    std::array<std::int64_t, 3> result{};
    for (int axis = 0; axis < 3; ++axis) {
        const double value = std::round((point_world[axis] - grid.origin_world[axis]) / grid.step_m);
        HW_ASSERT(std::abs(value) <= static_cast<double>(kMaxGridCoordinate));
        result[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(value);
    }
    return result;
}

ExactPlane make_plane(const std::array<std::int64_t, 3>& normal, Int128 offset)
{
    const std::int64_t divisor_of_normal = std::gcd(std::gcd(normal[0], normal[1]), normal[2]);
    HW_ASSERT(divisor_of_normal != 0);
    const Int128 divisor = greatest_divisor(offset, divisor_of_normal);
    ExactPlane plane;
    for (std::size_t i = 0; i < 3; ++i) plane.normal[i] = static_cast<std::int64_t>(normal[i] / divisor);
    plane.offset = offset / divisor;
    const glm::dvec3 rounded(static_cast<double>(plane.normal[0]), static_cast<double>(plane.normal[1]),
                             static_cast<double>(plane.normal[2]));
    const double length = std::sqrt(rounded.x * rounded.x + rounded.y * rounded.y + rounded.z * rounded.z);
    plane.unit_normal = rounded / length;
    plane.unit_offset = to_double(plane.offset) / length;
    return plane;
}

SidePlane PlaneSet::add(const ExactPlane& plane)
{
    ExactPlane canonical = plane;
    const bool is_flipped = !looks_forward(plane.normal);
    if (is_flipped) {
        for (std::int64_t& n : canonical.normal) n = -n;
        canonical.offset = -canonical.offset;
        canonical.unit_normal = -canonical.unit_normal;
        canonical.unit_offset = -canonical.unit_offset;
    }
    const std::uint64_t hash = hash_of(canonical.normal, canonical.offset);
    const auto [first, last] = by_hash_.equal_range(hash);
    for (auto it = first; it != last; ++it) {
        const ExactPlane& known = planes_[static_cast<std::size_t>(it->second)];
        if (known.normal == canonical.normal && known.offset == canonical.offset) return {it->second, is_flipped};
    }
    by_hash_.emplace(hash, size());
    planes_.push_back(canonical);
    return {size() - 1, is_flipped};
}

std::uint64_t& exact_fallback_count()
{
    thread_local std::uint64_t count = 0;
    return count;
}

int PlaneSet::sign(int plane, int a, int b, int c, const glm::dvec3& point_grid) const
{
    if (plane == a || plane == b || plane == c) return 0;
    const ExactPlane& h = (*this)[plane];
    const double distance = h.distance(point_grid);
    if (distance > kSureDistance) return 1;
    if (distance < -kSureDistance) return -1;
    ++exact_fallback_count();
    const ExactPlane &pa = (*this)[a], &pb = (*this)[b], &pc = (*this)[c];
    // The determinant of the four planes is that of the three normals times the value of h at the point.
    const WideInt three = determinant(pa.normal, pb.normal, pc.normal);
    const WideInt four = WideInt(h.offset) * three - WideInt(pc.offset) * determinant(pa.normal, pb.normal, h.normal) +
                         WideInt(pb.offset) * determinant(pa.normal, pc.normal, h.normal) -
                         WideInt(pa.offset) * determinant(pb.normal, pc.normal, h.normal);
    HW_ASSERT(three.sign() != 0);
    return four.sign() * three.sign();
}

glm::dvec3 PlaneSet::meeting_point(int a, int b, int c) const
{
    const ExactPlane &pa = (*this)[a], &pb = (*this)[b], &pc = (*this)[c];
    const std::array<Int128, 3> bc = cross(pb.normal, pc.normal);
    const std::array<Int128, 3> ca = cross(pc.normal, pa.normal);
    const std::array<Int128, 3> ab = cross(pa.normal, pb.normal);
    const double below = determinant(pa.normal, pb.normal, pc.normal).to_double();
    HW_ASSERT(below != 0.0);
    glm::dvec3 point;
    for (std::size_t i = 0; i < 3; ++i) {
        const WideInt above = WideInt(pa.offset) * WideInt(bc[i]) + WideInt(pb.offset) * WideInt(ca[i]) +
                              WideInt(pc.offset) * WideInt(ab[i]);
        point[static_cast<int>(i)] = -above.to_double() / below;
    }
    return point;
}

namespace {

/// Adds `value` to the nonoverlapping sum in `parts` (Shewchuk's grow-expansion), dropping zeros.
void grow(std::vector<double>& parts, double value)
{
    double carried = value;
    std::size_t kept = 0;
    for (const double part : parts) {
        const double sum = carried + part;
        const double virtual_part = sum - carried;
        const double error = (carried - (sum - virtual_part)) + (part - virtual_part);
        if (error != 0.0) parts[kept++] = error;
        carried = sum;
    }
    parts.resize(kept);
    if (carried != 0.0) parts.push_back(carried);
}

void grow_product(std::vector<double>& parts, double a, double b)
{
    const double high = a * b;
    grow(parts, std::fma(a, b, -high));
    grow(parts, high);
}

/// `value` as a sum of doubles, exactly.
std::array<double, 4> split_exactly(Int128 value)
{
    std::array<double, 4> result{};
    for (double& part : result) {
        part = to_double(value);
        value -= static_cast<Int128>(part);
    }
    return result;
}

}  // namespace

int exact_sign(const Grid& grid, const ExactPlane& plane, const glm::dvec3& point_world)
{
    const glm::dvec3 point_grid = (point_world - grid.origin_world) / grid.step_m;
    const double distance = plane.distance(point_grid);
    const double reach = std::abs(point_grid.x) + std::abs(point_grid.y) + std::abs(point_grid.z);
    const double unsure = 0x1p-49 * (reach + std::abs(plane.unit_offset));
    if (distance > unsure) return 1;
    if (distance < -unsure) return -1;

    std::vector<double> parts;
    for (int axis = 0; axis < 3; ++axis) {
        // The step is a power of two: multiplying the offset by it instead of dividing the point keeps all digits.
        for (const double n : split_exactly(plane.normal[static_cast<std::size_t>(axis)])) {
            grow_product(parts, n, point_world[axis]);
            grow_product(parts, n, -grid.origin_world[axis]);
        }
    }
    for (const double d : split_exactly(plane.offset)) grow(parts, d * grid.step_m);
    if (parts.empty()) return 0;
    return parts.back() > 0.0 ? 1 : -1;
}

}  // namespace hw
