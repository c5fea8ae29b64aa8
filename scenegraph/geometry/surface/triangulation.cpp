#include "hatchway/geometry/surface/triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace hw {
namespace {

/// Twice the polygon's area, along its normal (Newell). Taken from the first corner, so that a far origin costs
/// nothing.
glm::dvec3 area_vector(std::span<const glm::vec3> polygon)
{
    const glm::dvec3 origin(polygon[0]);
    glm::dvec3 sum(0.0);
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        sum += glm::cross(glm::dvec3(polygon[i]) - origin, glm::dvec3(polygon[i + 1]) - origin);
    return sum;
}

/// The corners without the coordinate along which the area vector is longest; counter-clockwise.
std::vector<glm::dvec2> flattened(std::span<const glm::vec3> polygon)
{
    const glm::dvec3 area = area_vector(polygon);
    const glm::dvec3 size = glm::abs(area);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const bool is_flipped = area[axis] < 0.0;
    std::vector<glm::dvec2> flat;
    flat.reserve(polygon.size());
    for (const glm::vec3& corner : polygon) flat.emplace_back(is_flipped ? -corner[u] : corner[u], corner[v]);
    return flat;
}

/// Twice the signed area of a triangle.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// A polygon from which ears are cut. What a corner's triangle has been compared with stays compared until one of its
/// neighbours is cut: at most all concave corners for each corner and for each neighbour of a cut, together a square.
class Ring {
 public:
    explicit Ring(std::vector<glm::dvec2> corners)
        : corners_(std::move(corners)),
          next_(corners_.size()),
          is_concave_(corners_.size(), false),
          compared_(corners_.size(), 0)
    {
        previous_.resize(corners_.size());
        const auto count = static_cast<std::uint32_t>(corners_.size());
        for (std::uint32_t i = 0; i < count; ++i) next_[i] = (i + 1) % count;
        for (std::uint32_t i = 0; i < count; ++i) previous_[next_[i]] = i;
        for (std::uint32_t i = 0; i < count; ++i)
            if (turn_at(i) <= 0.0) concave_.push_back(i);
        for (const std::uint32_t i : concave_) is_concave_[i] = true;
    }
    bool is_convex() const { return concave_.empty(); }

    void cut_all(std::vector<std::uint32_t>& triangles)
    {
        std::uint32_t at = 0;
        std::size_t passed = 0;  // corners since the last ear: once round means that there is none
        for (std::size_t left = corners_.size(); left > 2;) {
            if (!is_ear(at) && passed < left) {
                at = next_[at];
                ++passed;
                continue;
            }
            triangles.insert(triangles.end(), {previous_[at], at, next_[at]});
            at = cut(at);
            passed = 0;
            --left;
        }
    }

 private:
    double turn_at(std::uint32_t i) const { return turn(corners_[previous_[i]], corners_[i], corners_[next_[i]]); }

    /// Only a concave corner can lie in the way.
    bool is_ear(std::uint32_t i)
    {
        if (turn_at(i) <= 0.0) return false;
        const glm::dvec2& a = corners_[previous_[i]];
        const glm::dvec2& b = corners_[i];
        const glm::dvec2& c = corners_[next_[i]];
        const auto is_in_the_way = [&](std::uint32_t other) {
            const glm::dvec2& p = corners_[other];
            if (!is_concave_[other] || p == a || p == b || p == c) return false;
            return turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
        };
        std::uint32_t& at = compared_[i];
        while (at < concave_.size() && !is_in_the_way(concave_[at])) ++at;
        return at == concave_.size();
    }

    /// Takes a corner out and gives the next to look at: two on, so that a round shape is not cut into one long fan.
    std::uint32_t cut(std::uint32_t i)
    {
        const std::uint32_t before = previous_[i];
        const std::uint32_t after = next_[i];
        next_[before] = after;
        previous_[after] = before;
        is_concave_[i] = false;
        for (const std::uint32_t neighbour : {before, after}) {
            if (turn_at(neighbour) > 0.0) is_concave_[neighbour] = false;
            compared_[neighbour] = 0;
        }
        return next_[after];
    }

    std::vector<glm::dvec2> corners_;
    std::vector<std::uint32_t> next_;
    std::vector<std::uint32_t> previous_;
    std::vector<std::uint32_t> concave_;   ///< Or straight, at first; cutting ears never makes a convex corner concave.
    std::vector<bool> is_concave_;         ///< Still.
    std::vector<std::uint32_t> compared_;  ///< So many of concave_ are not in the way of a corner's ear.
};

}  // namespace

void triangulate(std::span<const glm::vec3> polygon, std::vector<std::uint32_t>& triangles)
{
    const auto count = static_cast<std::uint32_t>(polygon.size());
    if (count > 3) {
        Ring ring(flattened(polygon));
        if (!ring.is_convex()) {
            ring.cut_all(triangles);
            return;
        }
    }
    for (std::uint32_t i = 1; i + 1 < count; ++i) triangles.insert(triangles.end(), {0, i, i + 1});
}

}  // namespace hw
