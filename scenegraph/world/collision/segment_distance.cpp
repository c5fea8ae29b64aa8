#include "hatchway/world/collision/segment_distance.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>

namespace hw {
namespace {

glm::dvec3 nearest_on_triangle(const glm::dvec3& p, const std::array<glm::dvec3, 3>& triangle)
{
    const auto& [a, b, c] = triangle;
    const glm::dvec3 ab = b - a, ac = c - a, ap = p - a;
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
    if (d1 <= 0.0 && d2 <= 0.0) return a;
    const glm::dvec3 bp = p - b;
    const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    if (d3 >= 0.0 && d4 <= d3) return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + ab * (d1 / (d1 - d3));
    const glm::dvec3 cp = p - c;
    const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d6 >= 0.0 && d5 <= d6) return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + ac * (d2 / (d2 - d6));
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    const double sum = va + vb + vc;
    return a + ab * (vb / sum) + ac * (vc / sum);
}

NearestPoints nearest_of_segments(const Segment3& s, const Segment3& t)
{
    const glm::dvec3 d1 = s.b - s.a, d2 = t.b - t.a, r = s.a - t.a;
    const double a = glm::dot(d1, d1), e = glm::dot(d2, d2), f = glm::dot(d2, r);
    double along_s = 0.0;
    double along_t = 0.0;
    if (a <= 0.0) {
        along_t = e > 0.0 ? std::clamp(f / e, 0.0, 1.0) : 0.0;
    } else {
        const double c = glm::dot(d1, r), b = glm::dot(d1, d2);
        const double below = a * e - b * b;
        if (below > 0.0) along_s = std::clamp((b * f - c * e) / below, 0.0, 1.0);
        along_t = e > 0.0 ? (b * along_s + f) / e : 0.0;
        if (along_t < 0.0 || along_t > 1.0) {
            along_t = std::clamp(along_t, 0.0, 1.0);
            along_s = std::clamp((b * along_t - c) / a, 0.0, 1.0);
        }
    }
    return {s.a + d1 * along_s, t.a + d2 * along_t};
}

std::optional<glm::dvec3> crossing(const Segment3& segment, const std::array<glm::dvec3, 3>& triangle)
{
    const glm::dvec3 normal = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    const double from = glm::dot(segment.a - triangle[0], normal);
    const double to = glm::dot(segment.b - triangle[0], normal);
    if (from * to > 0.0 || from == to) return std::nullopt;
    const glm::dvec3 point = segment.a + (segment.b - segment.a) * (from / (from - to));
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3& corner = triangle[i];
        const glm::dvec3 side = triangle[(i + 1) % 3] - corner;
        if (glm::dot(glm::cross(side, point - corner), normal) < 0.0) return std::nullopt;
    }
    return point;
}

double squared_distance(const NearestPoints& pair)
{
    const glm::dvec3 apart = pair.on_segment - pair.on_triangle;
    return glm::dot(apart, apart);
}

}  // namespace

NearestPoints nearest_points(const Segment3& segment, const std::array<glm::dvec3, 3>& triangle)
{
    if (const auto point = crossing(segment, triangle)) return {*point, *point};
    NearestPoints best{segment.a, nearest_on_triangle(segment.a, triangle)};
    const auto offer = [&](const NearestPoints& pair) {
        // Between equals the first stays: a corner's foot on the triangle has the cleanest direction.
        if (squared_distance(pair) < (1.0 - 1e-12) * squared_distance(best)) best = pair;
    };
    offer({segment.b, nearest_on_triangle(segment.b, triangle)});
    for (std::size_t i = 0; i < 3; ++i) offer(nearest_of_segments(segment, {triangle[i], triangle[(i + 1) % 3]}));
    return best;
}

}  // namespace hw
