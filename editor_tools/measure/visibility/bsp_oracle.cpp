#include "measure/visibility/bsp_oracle.hpp"

#include <gmpxx.h>

namespace hw::measure {
namespace {

mpz_class whole(Int128 value)
{
    const bool is_negative = value < 0;
    const auto rest = is_negative ? -static_cast<unsigned __int128>(value) : static_cast<unsigned __int128>(value);
    mpz_class result = static_cast<unsigned long>(rest >> 64);
    result = (result << 64) + mpz_class(static_cast<unsigned long>(rest));
    return is_negative ? mpz_class(-result) : result;
}

int sign_at(const Grid& grid, const ExactPlane& plane, const glm::dvec3& point)
{
    mpq_class sum = mpq_class(whole(plane.offset)) * mpq_class(grid.step_m);
    for (int axis = 0; axis < 3; ++axis) {
        const mpq_class way = mpq_class(point[axis]) - mpq_class(grid.origin_world[axis]);
        sum += mpq_class(whole(plane.normal[static_cast<std::size_t>(axis)])) * way;
    }
    return sgn(sum);
}

}  // namespace

int leaf_by_rationals(const BspTree& tree, const glm::dvec3& point_world)
{
    for (int axis = 0; axis < 3; ++axis) {
        if (point_world[axis] < tree.bounds_world.min[axis] || point_world[axis] > tree.bounds_world.max[axis])
            return -1;
    }
    int child = tree.nodes.empty() ? ~0 : 0;
    while (child >= 0) {
        const BspNode& node = tree.nodes[static_cast<std::size_t>(child)];
        child = sign_at(tree.grid, node.plane, point_world) > 0 ? node.front : node.back;
    }
    return ~child;
}

}  // namespace hw::measure
