#include "hatchway/world/visibility/rows/opening_hulls.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace hw {
namespace {

/// The convex hull of points of a plane, counter-clockwise about `normal`. Andrew's monotone chain.
Opening hull_of(Opening points, const glm::dvec3& normal)
{
    const glm::dvec3 helper = std::abs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(helper, normal));
    const glm::dvec3 v = glm::cross(normal, u);
    const auto before = [&](const glm::dvec3& a, const glm::dvec3& b) {
        const double ua = glm::dot(a, u), ub = glm::dot(b, u);
        return ua != ub ? ua < ub : glm::dot(a, v) < glm::dot(b, v);
    };
    std::sort(points.begin(), points.end(), before);
    const auto bends_left = [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        return glm::dot(glm::cross(b - a, c - b), normal) > 0.0;
    };
    Opening hull;
    const auto add = [&](const glm::dvec3& point, std::size_t base) {
        while (hull.size() >= base + 2 && !bends_left(hull[hull.size() - 2], hull.back(), point)) hull.pop_back();
        hull.push_back(point);
    };
    for (const glm::dvec3& point : points) add(point, 0);
    const std::size_t base = hull.size() - 1;
    for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], base);
    hull.pop_back();
    return hull;
}

/// Openings that shrink in number: hulls of those whose hull adds least.
class Simplifier {
 public:
    Simplifier(std::vector<Opening> openings, const glm::dvec3& normal)
        : openings_(std::move(openings)), normal_(normal)
    {
        for (const Opening& opening : openings_) areas_.push_back(area_of(opening));
    }

    std::vector<Opening> run()
    {
        merge_along_line();
        merge_pairs();
        return std::move(openings_);
    }

 private:
    static constexpr double kMostGrowth = 1.15;       // by which a hull may always exceed its parts
    static constexpr std::size_t kMostOpenings = 16;  // more than this are merged at any cost
    static constexpr std::size_t kMostPaired = 48;    // more than this are first merged with the next in order

    Opening hull_of_two(std::size_t a, std::size_t b) const
    {
        Opening points = openings_[a];
        points.insert(points.end(), openings_[b].begin(), openings_[b].end());
        return hull_of(std::move(points), normal_);
    }

    double added_by(std::size_t a, std::size_t b) const { return area_of(hull_of_two(a, b)) - areas_[a] - areas_[b]; }

    void join(std::size_t a, std::size_t b)
    {
        openings_[a] = hull_of_two(a, b);
        areas_[a] = area_of(openings_[a]);
        openings_.erase(openings_.begin() + static_cast<std::ptrdiff_t>(b));
        areas_.erase(areas_.begin() + static_cast<std::ptrdiff_t>(b));
    }

    void merge_along_line()
    {
        if (openings_.size() <= kMostPaired) return;
        std::vector<double> added;
        for (std::size_t i = 0; i + 1 < openings_.size(); ++i) added.push_back(added_by(i, i + 1));
        while (openings_.size() > kMostPaired) {
            const auto least = std::min_element(added.begin(), added.end());
            const std::size_t i = static_cast<std::size_t>(least - added.begin());
            join(i, i + 1);
            added.erase(least);
            if (i > 0) added[i - 1] = added_by(i - 1, i);
            if (i < added.size()) added[i] = added_by(i, i + 1);
        }
    }

    bool is_allowed(std::size_t a, std::size_t b, double added) const
    {
        return openings_.size() > kMostOpenings || added <= (kMostGrowth - 1.0) * (areas_[a] + areas_[b]);
    }

    void merge_pairs()
    {
        std::vector<std::vector<double>> added(openings_.size());  // by the lower, then by the higher number
        for (std::size_t a = 0; a < openings_.size(); ++a) {
            added[a].resize(openings_.size());
            for (std::size_t b = a + 1; b < openings_.size(); ++b) added[a][b] = added_by(a, b);
        }
        while (openings_.size() > 1) {
            std::size_t best_a = 0;
            std::size_t best_b = 0;
            for (std::size_t a = 0; a < openings_.size(); ++a) {
                for (std::size_t b = a + 1; b < openings_.size(); ++b) {
                    const bool is_less = best_b == 0 || added[a][b] < added[best_a][best_b];
                    if (is_less && is_allowed(a, b, added[a][b])) best_a = a, best_b = b;
                }
            }
            if (best_b == 0) return;
            join(best_a, best_b);
            added.erase(added.begin() + static_cast<std::ptrdiff_t>(best_b));
            for (std::vector<double>& row : added) row.erase(row.begin() + static_cast<std::ptrdiff_t>(best_b));
            for (std::size_t other = 0; other < openings_.size(); ++other) {
                if (other == best_a) continue;
                added[std::min(other, best_a)][std::max(other, best_a)] =
                    added_by(std::min(other, best_a), std::max(other, best_a));
            }
        }
    }

    std::vector<Opening> openings_;
    std::vector<double> areas_;
    glm::dvec3 normal_;
};

}  // namespace

glm::dvec3 area_vector(const Opening& opening)
{
    glm::dvec3 sum(0.0);
    for (std::size_t i = 2; i < opening.size(); ++i) {
        sum += glm::cross(opening[i - 1] - opening[0], opening[i] - opening[0]);
    }
    return sum;
}

double area_of(const Opening& opening)
{
    return 0.5 * glm::length(area_vector(opening));
}

std::vector<Opening> joined_by_hulls(std::vector<Opening> openings, const glm::dvec3& normal)
{
    return Simplifier(std::move(openings), normal).run();
}

}  // namespace hw
