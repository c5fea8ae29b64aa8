#include "hatchway/render/view/covered_pixels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace hw {
namespace {

/// Positive in front of the near plane.
float before_near(const glm::vec4& clip)
{
    return clip.z + clip.w;
}

/// A triangle cut at the near plane: at most four corners, in clip space.
struct Cut {
    std::array<glm::vec4, 4> corners;
    int count = 0;
};

Cut cut_at_near(const std::array<glm::vec4, 3>& triangle)
{
    Cut cut;
    for (int i = 0; i < 3; ++i) {
        const glm::vec4 &a = triangle[i], &b = triangle[(i + 1) % 3];
        const float at_a = before_near(a), at_b = before_near(b);
        if (at_a > 0.0f) cut.corners[cut.count++] = a;
        if ((at_a > 0.0f) != (at_b > 0.0f)) cut.corners[cut.count++] = glm::mix(a, b, at_a / (at_a - at_b));
    }
    return cut;
}

double covered_by(const Cut& cut, float facing, const glm::dvec2& size)
{
    glm::dvec2 low(size), high(0.0);
    std::array<glm::dvec2, 4> at;
    for (int i = 0; i < cut.count; ++i) {
        at[i] = (glm::dvec2(cut.corners[i]) / static_cast<double>(cut.corners[i].w) * 0.5 + 0.5) * size;
        low = glm::min(low, at[i]);
        high = glm::max(high, at[i]);
    }
    double area = 0.0;
    for (int i = 2; i < cut.count; ++i) {
        const glm::dvec2 a = at[i - 1] - at[0], b = at[i] - at[0];
        area += 0.5 * (a.x * b.y - a.y * b.x);
    }
    if (facing * area < 0.0) return 0.0;
    const glm::dvec2 seen = glm::max(glm::min(high, size) - glm::max(low, glm::dvec2(0.0)), glm::dvec2(0.0));
    return std::min(std::abs(area), seen.x * seen.y);
}

}  // namespace

double covered_pixels(const MeshData& mesh, std::span<const IndexRange> ranges, const glm::mat4& clip_from_object,
                      float facing, glm::ivec2 size_px)
{
    double covered = 0.0;
    for (const IndexRange& range : ranges)
        for (std::uint32_t i = range.first; i + 2 < range.first + range.count; i += 3) {
            std::array<glm::vec4, 3> corners;
            for (int k = 0; k < 3; ++k)
                corners[k] = clip_from_object * glm::vec4(mesh.positions[mesh.indices[i + k]], 1.0f);
            covered += covered_by(cut_at_near(corners), facing, glm::dvec2(size_px));
        }
    return covered;
}

double most_covered_pixels(double area, const Box& bounds, const glm::mat4& clip_from_object, glm::ivec2 size_px)
{
    constexpr double kObliqueness = 4.0;  // how much larger a piece can be at the edge of a wide picture
    float least_w = std::numeric_limits<float>::infinity();
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 place(corner & 1 ? bounds.max.x : bounds.min.x, corner & 2 ? bounds.max.y : bounds.min.y,
                              corner & 4 ? bounds.max.z : bounds.min.z);
        least_w = std::min(least_w, (clip_from_object * glm::vec4(place, 1.0f)).w);
    }
    if (least_w <= 0.0f) return std::numeric_limits<double>::infinity();
    const auto row = [&](int i) {
        return glm::dvec3(clip_from_object[0][i], clip_from_object[1][i], clip_from_object[2][i]);
    };
    const double px_per_unit = 0.5 * std::max(glm::length(row(0)) * size_px.x, glm::length(row(1)) * size_px.y);
    const double scale = px_per_unit / least_w;
    return kObliqueness * area * scale * scale;
}

}  // namespace hw
