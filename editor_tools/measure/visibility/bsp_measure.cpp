#include "measure/visibility/bsp_measure.hpp"

#include <cmath>
#include <random>

#include "measure/no_value.hpp"
#include "measure/visibility/bsp_oracle.hpp"

namespace hw::measure {

std::uint64_t misclassified(const BspTree& tree, std::uint64_t points, std::uint32_t seed)
{
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::uint64_t wrong = 0;
    for (std::uint64_t i = 0; i < points; ++i) {
        glm::dvec3 point =
            tree.bounds_world.min + tree.bounds_world.size() * glm::dvec3(share(engine), share(engine), share(engine));
        if (i % 2 == 1 && !tree.nodes.empty()) {
            const ExactPlane& plane = tree.nodes[engine() % tree.nodes.size()].plane;
            const double distance = plane.distance((point - tree.grid.origin_world) / tree.grid.step_m);
            const double aside = std::pow(10.0, -12.0 * share(engine)) * (share(engine) - 0.5);
            point -= plane.unit_normal * ((distance + aside) * tree.grid.step_m);
        }
        wrong += leaf_at(tree, point) != leaf_by_rationals(tree, point);
    }
    return wrong;
}

double relative_area_error(double area_m2, const BspBuild& build)
{
    double sum = 0.0;
    for (const auto& pieces : build.polygons_of_node) {
        for (const BlockingPolygon& piece : pieces) sum += area(piece.polygon);
    }
    return std::abs(share_of(sum * build.tree.grid.step_m * build.tree.grid.step_m, area_m2) - 1.0);
}

}  // namespace hw::measure
