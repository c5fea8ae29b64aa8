#include "measure/pvs_measure.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "measure/pvs_rays.hpp"

namespace hw::measure {
namespace {

constexpr int kRaysPerPlace = 64;
constexpr std::uint64_t kEnoughRays = 2000;  // for a cluster's sampled truth

class Dice {
 public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}
    double share() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
    glm::dvec3 direction()
    {
        const double z = 2.0 * share() - 1.0;
        const double turn = 2.0 * 3.14159265358979323846 * share();
        const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
        return {r * std::cos(turn), z, r * std::sin(turn)};
    }
    glm::dvec3 in_box(const Box& box) { return box.min + box.size() * glm::dvec3(share(), share(), share()); }
    glm::dvec3 near_triangle(const SightTriangle& triangle, double reach)
    {
        double u = share(), v = share();
        if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
        const glm::dvec3 normal = glm::normalize(glm::cross(triangle.b - triangle.a, triangle.c - triangle.a));
        const double height = reach * std::pow(share(), 3.0);
        return triangle.a + u * (triangle.b - triangle.a) + v * (triangle.c - triangle.a) + (height + 1e-4) * normal;
    }

 private:
    std::mt19937_64 engine_;
};

/// What the rays of one cluster have met.
struct ClusterTruth {
    std::uint64_t rays = 0;
    std::vector<std::uint8_t> met;  ///< By slot.
};

double share_of(const std::vector<std::uint8_t>& slots, const std::vector<double>& triangles_of_slot)
{
    double seen = 0.0, total = 0.0;
    for (std::size_t i = 0; i < triangles_of_slot.size(); ++i) {
        total += triangles_of_slot[i];
        if (i < slots.size() && slots[i]) seen += triangles_of_slot[i];
    }
    return total > 0.0 ? seen / total : 1.0;
}

void compare_shares(const Visibility& visibility, const std::vector<ClusterTruth>& truths,
                    const std::vector<double>& triangles_of_slot, PvsRayResult& result)
{
    for (std::size_t cluster = 0; cluster < truths.size(); ++cluster) {
        if (truths[cluster].rays < kEnoughRays) continue;
        std::vector<std::uint8_t> row(triangles_of_slot.size());
        visit_bits(visibility.slot_rows.row(static_cast<int>(cluster)),
                   [&](int slot) { row[static_cast<std::size_t>(slot)] = 1; });
        ++result.clusters;
        result.row_share += share_of(row, triangles_of_slot);
        result.sampled_share += share_of(truths[cluster].met, triangles_of_slot);
    }
    if (result.clusters == 0) return;
    result.row_share /= result.clusters;
    result.sampled_share /= result.clusters;
}

}  // namespace

PvsRayResult measure_pvs(const Scene& scene, std::span<const MeshChunks> chunks_of_mesh, const Visibility& visibility,
                         const PvsRayOptions& options)
{
    PvsRayResult result;
    const std::vector<SightTriangle> triangles = sight_triangles(scene, chunks_of_mesh);
    if (triangles.empty()) return result;
    std::vector<double> triangles_of_slot(visibility.slots.size());
    for (const SightTriangle& triangle : triangles) triangles_of_slot[triangle.slot] += 1.0;
    const SightRays rays(triangles);
    Dice dice(options.seed);
    std::vector<ClusterTruth> truths(static_cast<std::size_t>(visibility.tree.cluster_count));
    std::vector<std::uint8_t> is_visible;
    std::vector<std::uint32_t> met;
    const glm::dvec3 size = scene.bounds_world.size();
    const double reach = 0.1 * std::max({size.x, size.y, size.z});
    for (std::uint64_t place = 0; place * 2 < 3 * options.rays && result.rays < options.rays; ++place) {
        const glm::dvec3 eye = place % 2 == 0 ? dice.in_box(scene.bounds_world)
                                              : dice.near_triangle(triangles[dice.below(triangles.size())], reach);
        const int leaf = leaf_at(visibility.tree, eye);
        if (leaf < 0 || visibility.tree.is_solid[static_cast<std::size_t>(leaf)]) continue;
        visible_chunks(visibility, eye, 0.0, is_visible);
        const int cluster = visibility.tree.cluster_of_leaf[static_cast<std::size_t>(leaf)];
        ClusterTruth& truth = truths[static_cast<std::size_t>(cluster)];
        truth.met.resize(visibility.slots.size());
        for (int ray = 0; ray < kRaysPerPlace; ++ray) {
            const glm::dvec3 direction = dice.direction();
            rays.trace(eye, direction, met);
            ++result.rays;
            ++truth.rays;
            for (const std::uint32_t number : met) {
                ++result.hits;
                const std::uint32_t slot = triangles[number].slot;
                truth.met[slot] = 1;
                if (is_visible[slot]) continue;
                ++result.claims;
                if (!is_seen_exactly(triangles, eye, direction, number)) continue;
                ++result.false_invisibles;
                if (result.examples.size() < 16) result.examples.push_back({eye, direction, slot});
            }
        }
    }
    compare_shares(visibility, truths, triangles_of_slot, result);
    return result;
}

}  // namespace hw::measure
