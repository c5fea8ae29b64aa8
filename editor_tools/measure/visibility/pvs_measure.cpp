#include "measure/visibility/pvs_measure.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <mutex>
#include <random>

#include "measure/share_work.hpp"
#include "measure/visibility/pvs_rays.hpp"

namespace hw::measure {
namespace {

constexpr int kRaysPerPlace = 64;
constexpr std::uint64_t kPlacesOfBatch = 256;
constexpr std::size_t kMostExamples = 16;
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
    glm::dvec3 on_triangle(const SightTriangle& triangle)
    {
        double u = share(), v = share();
        if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
        return triangle.a + u * (triangle.b - triangle.a) + v * (triangle.c - triangle.a);
    }
    glm::dvec3 near_triangle(const SightTriangle& triangle, double reach)
    {
        const glm::dvec3 place = on_triangle(triangle);
        const glm::dvec3 normal = glm::normalize(glm::cross(triangle.b - triangle.a, triangle.c - triangle.a));
        const double height = reach * std::pow(share(), 3.0);
        return place + (height + 1e-4) * normal;
    }

 private:
    std::mt19937_64 engine_;
};

/// What the rays of one cluster have met.
struct ClusterTruth {
    std::uint64_t rays = 0;
    std::vector<std::uint8_t> met;  ///< By slot.
};

double triangle_share(const std::vector<std::uint8_t>& slots, const std::vector<double>& triangles_of_slot)
{
    double seen = 0.0, total = 0.0;
    for (std::size_t i = 0; i < triangles_of_slot.size(); ++i) {
        total += triangles_of_slot[i];
        if (i < slots.size() && slots[i]) seen += triangles_of_slot[i];
    }
    return share_of(seen, total);
}

void compare_shares(const Visibility& visibility, const std::map<int, ClusterTruth>& truths,
                    const std::vector<double>& triangles_of_slot, PvsRayResult& result)
{
    double rows = 0.0, met = 0.0;
    for (const auto& [cluster, truth] : truths) {
        if (truth.rays < kEnoughRays) continue;
        std::vector<std::uint8_t> row(triangles_of_slot.size());
        visit_bits(visibility.slot_rows.row(cluster), [&](int slot) { row[static_cast<std::size_t>(slot)] = 1; });
        ++result.clusters;
        rows += triangle_share(row, triangles_of_slot);
        met += triangle_share(truth.met, triangles_of_slot);
    }
    result.row_share = share_of(rows, result.clusters);
    result.sampled_share = share_of(met, result.clusters);
}

/// What a batch of rays, or of batches, has found.
struct Tally {
    PvsRayResult result;
    std::map<int, ClusterTruth> truths;  ///< By cluster.

    void add(const Tally& other)
    {
        result.rays += other.result.rays;
        result.hits += other.result.hits;
        result.claims += other.result.claims;
        result.false_invisibles += other.result.false_invisibles;
        for (const FalseInvisible& example : other.result.examples)
            if (result.examples.size() < kMostExamples) result.examples.push_back(example);
        for (const auto& [cluster, truth] : other.truths) {
            ClusterTruth& own = truths[cluster];
            own.rays += truth.rays;
            own.met.resize(truth.met.size());
            for (std::size_t slot = 0; slot < truth.met.size(); ++slot) own.met[slot] |= truth.met[slot];
        }
    }
};

/// Shoots from random places of its own seed.
class Shooter {
 public:
    Shooter(const Scene& scene, const Visibility& visibility, const std::vector<SightTriangle>& triangles,
            const SightRays& rays)
        : scene_(scene), visibility_(visibility), triangles_(triangles), rays_(rays)
    {
        const glm::dvec3 size = scene.bounds_world.size();
        reach_ = 0.1 * std::max({size.x, size.y, size.z});
    }

    Tally shoot(std::uint64_t seed, std::uint64_t places) const
    {
        Tally tally;
        Dice dice(seed);
        std::uint64_t left = places;
        for (std::uint64_t attempt = 0; attempt < kMostAttempts * places && left > 0; ++attempt) {
            const glm::dvec3 eye = attempt % 2 == 0
                                       ? dice.in_box(scene_.bounds_world)
                                       : dice.near_triangle(triangles_[dice.below(triangles_.size())], reach_);
            const int leaf = leaf_at(visibility_.tree, eye);
            if (leaf < 0 || visibility_.tree.is_solid[static_cast<std::size_t>(leaf)]) continue;
            shoot_from(eye, visibility_.tree.cluster_of_leaf[static_cast<std::size_t>(leaf)], dice, tally);
            --left;
        }
        return tally;
    }

 private:
    static constexpr std::uint64_t kMostAttempts = 96;  // a scene may be solid nearly everywhere

    void shoot_from(const glm::dvec3& eye, int cluster, Dice& dice, Tally& tally) const
    {
        std::vector<std::uint8_t> is_visible;
        std::vector<std::uint32_t> met;
        visible_chunks(visibility_, eye, 0.0, is_visible);
        ClusterTruth& truth = tally.truths[cluster];
        truth.met.resize(visibility_.slots.size());
        for (int ray = 0; ray < kRaysPerPlace; ++ray) {
            const glm::dvec3 direction = ray % 2 == 0 ? dice.direction() : at_hidden(eye, is_visible, dice);
            rays_.trace(eye, direction, met);
            ++tally.result.rays;
            ++truth.rays;
            for (const std::uint32_t number : met) {
                ++tally.result.hits;
                const std::uint32_t slot = triangles_[number].slot;
                truth.met[slot] = 1;
                if (!is_visible[slot]) judge({eye, direction, slot}, number, tally.result);
            }
        }
    }

    /// At a triangle that the rows hide; anywhere when none was drawn by lot.
    glm::dvec3 at_hidden(const glm::dvec3& eye, const std::vector<std::uint8_t>& is_visible, Dice& dice) const
    {
        constexpr int kDraws = 16;
        for (int draw = 0; draw < kDraws; ++draw) {
            const SightTriangle& triangle = triangles_[dice.below(triangles_.size())];
            if (is_visible[triangle.slot]) continue;
            const glm::dvec3 way = dice.on_triangle(triangle) - eye;
            if (glm::dot(way, way) > 0.0) return glm::normalize(way);
        }
        return dice.direction();
    }

    void judge(const FalseInvisible& claim, std::uint32_t triangle, PvsRayResult& result) const
    {
        ++result.claims;
        if (!is_seen_exactly(triangles_, claim.origin, claim.direction, triangle)) return;
        ++result.false_invisibles;
        if (result.examples.size() < kMostExamples) result.examples.push_back(claim);
    }

    const Scene& scene_;
    const Visibility& visibility_;
    const std::vector<SightTriangle>& triangles_;
    const SightRays& rays_;
    double reach_ = 0.0;
};

}  // namespace

PvsRayResult measure_pvs(const Scene& scene, std::span<const MeshChunks> chunks_of_mesh, const Visibility& visibility,
                         const PvsRayOptions& options)
{
    const std::vector<SightTriangle> triangles = sight_triangles(scene, chunks_of_mesh);
    if (triangles.empty()) return {};
    std::vector<double> triangles_of_slot(visibility.slots.size());
    for (const SightTriangle& triangle : triangles) triangles_of_slot[triangle.slot] += 1.0;
    const SightRays rays(triangles);
    const Shooter shooter(scene, visibility, triangles, rays);
    const std::uint64_t places = (options.rays + kRaysPerPlace - 1) / kRaysPerPlace;
    const std::uint64_t batches = (places + kPlacesOfBatch - 1) / kPlacesOfBatch;
    Tally all;
    std::mutex mutex;  // sums and unions: the order of batches changes nothing but which examples are kept
    share_work(batches, static_cast<unsigned>(options.threads), [&](std::size_t batch) {
        const std::uint64_t wanted = std::min(kPlacesOfBatch, places - batch * kPlacesOfBatch);
        const Tally tally = shooter.shoot(options.seed * 0x9e3779b97f4a7c15ull + batch, wanted);
        const std::lock_guard lock(mutex);
        all.add(tally);
    });
    compare_shares(visibility, all.truths, triangles_of_slot, all.result);
    return all.result;
}

}  // namespace hw::measure
