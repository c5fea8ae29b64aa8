#include "hatchway/world/visibility/rows/surely_seen.hpp"

#include <cmath>
#include <limits>

namespace hw {
namespace {

constexpr int kLinesPerRound = 64;
constexpr int kMostRounds = 16;
constexpr int kMostLeavesOnWay = 400;
constexpr std::size_t kMostTests = 160'000'000;  // portals asked, by the lines of all sources

/// SplitMix64: small, and the same on every machine.
class Dice {
 public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}
    double share()
    {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ull);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }

 private:
    std::uint64_t state_;
};

/// A point of the portal, anywhere in it.
glm::dvec3 point_in(const Winding& winding, Dice& dice)
{
    glm::dvec3 sum(0.0);
    double total = 0.0;
    for (int i = 0; i < winding.count; ++i) {
        const double share = dice.share(), squared = share * share;
        const double weight = squared * squared + 1e-3;
        sum += weight * winding[i];
        total += weight;
    }
    return sum / total;
}

glm::dvec3 direction_through(const FlowPlane& plane, Dice& dice)
{
    while (true) {
        const glm::dvec3 way(2.0 * dice.share() - 1.0, 2.0 * dice.share() - 1.0, 2.0 * dice.share() - 1.0);
        const double length = glm::dot(way, way);
        const double forward = glm::dot(way, plane.normal);
        if (length > 1.0 || length < 1e-4 || std::abs(forward) < 1e-3) continue;
        return forward > 0.0 ? way : -way;
    }
}

bool is_within(const FlowPortal& portal, const glm::dvec3& point)
{
    const Winding& winding = portal.winding;
    for (int i = 0; i < winding.count; ++i) {
        const glm::dvec3 side = winding[i + 1 == winding.count ? 0 : i + 1] - winding[i];
        if (glm::dot(glm::cross(side, point - winding[i]), portal.plane.normal) < 0.0) return false;
    }
    return true;
}

struct Place {
    int leaf = 0;  ///< -1: the line meets a wall.
    double along = 0.0;
};

/// The next leaf on the line, behind the nearest portal past `place`.
Place next_place(const FlowGraph& graph, const Place& place, const glm::dvec3& from, const glm::dvec3& way)
{
    Place next{-1, std::numeric_limits<double>::infinity()};
    for (const int number : graph.portals_out_of[static_cast<std::size_t>(place.leaf)]) {
        const FlowPortal& portal = graph.portals[static_cast<std::size_t>(number)];
        const double speed = glm::dot(portal.plane.normal, way);
        if (speed <= 1e-6) continue;
        const double along = -portal.plane.distance(from) / speed;
        if (along <= place.along || along >= next.along || !is_within(portal, from + along * way)) continue;
        next = {portal.to_leaf, along};
    }
    return next;
}

}  // namespace

LeafBits surely_seen(const FlowGraph& graph, const FlowPortal& source)
{
    LeafBits seen(source.sees.size());
    set_bit(seen, source.to_leaf);
    Dice dice(static_cast<std::uint64_t>(source.to_leaf) + 1);
    const std::size_t most_tests = kMostTests / graph.portals.size();
    std::size_t tests = 0;
    for (int round = 0; round < kMostRounds; ++round) {
        int found = 0;
        for (int line = 0; line < kLinesPerRound && tests < most_tests; ++line) {
            const glm::dvec3 from = point_in(source.winding, dice);
            const glm::dvec3 way = direction_through(source.plane, dice);
            Place place{source.to_leaf, 0.0};
            for (int step = 0; step < kMostLeavesOnWay && place.leaf >= 0; ++step) {
                if (!has_bit(seen, place.leaf)) ++found;
                set_bit(seen, place.leaf);
                tests += graph.portals_out_of[static_cast<std::size_t>(place.leaf)].size();
                place = next_place(graph, place, from, way);
            }
        }
        if (found == 0) break;
    }
    return seen;
}

}  // namespace hw
