#include "hatchway/render/view/covered_pixels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

namespace hw {
namespace {

double covered_by(const std::array<glm::dvec2, 3>& corners, float facing, const glm::dvec2& size)
{
    const glm::dvec2 a = corners[1] - corners[0], b = corners[2] - corners[0];
    const double area = 0.5 * (a.x * b.y - a.y * b.x);
    if (facing * area < 0.0) return 0.0;
    const glm::dvec2 low = glm::max(glm::min(glm::min(corners[0], corners[1]), corners[2]), glm::dvec2(0.0));
    const glm::dvec2 high = glm::min(glm::max(glm::max(corners[0], corners[1]), corners[2]), size);
    const glm::dvec2 box = glm::max(high - low, glm::dvec2(0.0));
    return std::min(std::abs(area), box.x * box.y);
}

}  // namespace

double covered_pixels(const MeshData& mesh, std::span<const IndexRange> ranges, const glm::mat4& clip_from_object,
                      float facing, glm::ivec2 size_px)
{
    const glm::dvec2 size(size_px);
    double covered = 0.0;
    for (const IndexRange& range : ranges)
        for (std::uint32_t i = range.first; i + 2 < range.first + range.count; i += 3) {
            std::array<glm::dvec2, 3> corners;
            int behind = 0;
            for (int k = 0; k < 3; ++k) {
                const glm::vec4 clip = clip_from_object * glm::vec4(mesh.positions[mesh.indices[i + k]], 1.0f);
                behind += clip.w <= 0.0f ? 1 : 0;
                corners[k] = (glm::dvec2(clip) / static_cast<double>(clip.w) * 0.5 + 0.5) * size;
            }
            if (behind == 0) covered += covered_by(corners, facing, size);
            if (behind == 1 || behind == 2) covered += size.x * size.y;
        }
    return covered;
}

}  // namespace hw
