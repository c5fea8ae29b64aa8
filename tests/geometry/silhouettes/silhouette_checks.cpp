#include "tests/geometry/silhouettes/silhouette_checks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

namespace hw::test {

std::vector<glm::dvec3> eyes_around(const Surface& surface)
{
    std::vector<glm::dvec3> eyes;
    if (surface.faces.empty()) {
        ADD_FAILURE() << "a surface without faces shows nothing";
        return eyes;
    }
    glm::dvec3 low = surface.positions[0], high = low;
    for (const glm::vec3& p : surface.positions) {
        low = glm::min(low, glm::dvec3(p));
        high = glm::max(high, glm::dvec3(p));
    }
    const glm::dvec3 centre = 0.5 * (low + high), size = glm::max(high - low, glm::dvec3(1e-30));
    for (int i = 0; i < 27; ++i) {
        const glm::dvec3 direction(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        const int axes = std::abs(i % 3 - 1) + std::abs(i / 3 % 3 - 1) + std::abs(i / 9 - 1);
        if (axes == 1 || axes == 3) eyes.push_back(centre + 1.7 * direction * glm::length(size));
    }
    const auto corner = [&](std::size_t face, int i) {
        return glm::dvec3(surface.positions[surface.faces[face % surface.faces.size()][i]]);
    };
    const std::size_t step = surface.faces.size() / 7 + 1;
    for (std::size_t i = 0; i < 6; ++i) {
        const glm::dvec3 a = corner(i * step, 0), b = corner(i * step, 1), c = corner(i * step, 2);
        eyes.push_back(a + static_cast<double>(i) * (b - a) - 4.0 * (c - a));
    }
    eyes.push_back(corner(0, 0));
    eyes.push_back(corner(3 * step, 1));
    eyes.push_back(0.5 * (corner(2 * step, 0) + corner(2 * step, 1)));
    eyes.push_back(corner(4 * step, 0) + 0.25 * (corner(4 * step, 1) - corner(4 * step, 0)) +
                   0.5 * (corner(4 * step, 2) - corner(4 * step, 0)));
    eyes.push_back(corner(5 * step, 0) + 8.0 * (corner(5 * step, 1) - corner(5 * step, 0)));
    eyes.push_back(centre);
    return eyes;
}

std::vector<OracleEdge> found_edges(const Surface& surface, const Viewpoint& viewpoint, SilhouetteScratch& scratch,
                                    const SilhouetteOptions& options)
{
    std::vector<OracleEdge> found;
    for (const std::uint32_t edge : all_silhouettes(surface, viewpoint, options, scratch)) {
        const auto [u, v] = edge_vertices(surface, edge);
        found.push_back({std::min(u, v), std::max(u, v)});
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::size_t wrong_edges(const Surface& surface, const Viewpoint& viewpoint, const SilhouetteOracle& oracle,
                        SilhouetteScratch& scratch, FacingPrecision precision)
{
    const auto expected = oracle.silhouettes(viewpoint.eye, viewpoint.is_orthographic ? 0.0 : 1.0);
    std::vector<SilhouetteMethod> methods{SilhouetteMethod::brute};
    if (precision == FacingPrecision::exact && !surface.clusters.is_empty())
        methods.push_back(SilhouetteMethod::hierarchy);
    std::size_t wrong = 0;
    for (const SilhouetteMethod method : methods) {
        const SilhouetteOptions options{.precision = precision, .method = method};
        const auto errors = oracle.judge(found_edges(surface, viewpoint, scratch, options), expected);
        wrong += errors.false_positives + errors.false_negatives + errors.odd_vertices;
    }
    return wrong;
}

std::size_t wrong_edges_in_all_views(const Surface& surface, bool every_sign_rational)
{
    using Arithmetic = SilhouetteOracle::Arithmetic;
    // Which faces have no plane of their own is a matter of definition; what follows from it is judged.
    std::vector<OraclePlane> given;
    for (const auto& [face, source] : surface.filter.inherited) given.push_back({face, source});
    const SilhouetteOracle oracle(surface.positions, surface.faces,
                                  every_sign_rational ? Arithmetic::rational_only : Arithmetic::filtered, given);
    SilhouetteScratch scratch;
    std::size_t wrong = 0;
    for (const glm::dvec3& eye : eyes_around(surface)) wrong += wrong_edges(surface, {eye}, oracle, scratch);
    return wrong;
}

}  // namespace hw::test
