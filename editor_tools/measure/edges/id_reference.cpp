#include "measure/edges/id_reference.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "hatchway/render/products/triangle_tables.hpp"
#include "hatchway/render/view/frame_block.hpp"

namespace hw {
namespace {

constexpr float kRounding = 1.0f / 65536.0f;
constexpr std::uint8_t kMarked = 192;  // inner edges one pixel wide cover half of a pixel

std::size_t index(const IdImage& image, glm::ivec2 at)
{
    const glm::ivec2 inside = glm::clamp(at, glm::ivec2(0), image.size_px - 1);
    return static_cast<std::size_t>(inside.y) * image.size_px.x + inside.x;
}

}  // namespace

IdReference::IdReference(const Scene& scene) : corners_(triangle_corners(scene)) {}

int IdReference::common_corners(std::uint32_t a, std::uint32_t b) const
{
    int count = 0;
    for (int i = 0; i < 3; ++i) {
        const glm::uvec3 corner(corners_[3 * (a - 1) + i]);
        bool is_common = false;
        for (int j = 0; j < 3; ++j) is_common |= corner == glm::uvec3(corners_[3 * (b - 1) + j]);
        count += is_common ? 1 : 0;
    }
    return count;
}

float IdReference::height_px(std::uint32_t id, float nearness, const View& view) const
{
    const float scale = view.is_orthographic() ? focal_px(view) : focal_px(view) * nearness;
    return std::bit_cast<float>(corners_[3 * (id - 1) + 1].w) * scale;
}

IdReference::Crack IdReference::crack(const IdImage& image, glm::ivec2 at, glm::ivec2 way, const View& view,
                                      const Rule& rule) const
{
    const std::size_t here = index(image, at), there = index(image, at + way);
    const std::uint32_t a = image.ids[here], b = image.ids[there];
    if (a == b || a == 0) return {};
    if (b == 0) return {.ends = true};
    const int common = common_corners(a, b);
    if (rule.is_of_2011) return {.ends = common == 0};
    const glm::vec4 &p = image.planes[here], &q = image.planes[there];
    const float on_p = way.x != 0 ? static_cast<float>(way.x) * p.y : static_cast<float>(way.y) * p.z;
    const float on_q = way.x != 0 ? static_cast<float>(way.x) * q.y : static_cast<float>(way.y) * q.z;
    const float bend_p = q.x - (p.x + on_p), bend_q = p.x - (q.x - on_q);
    const bool is_one_object = corners_[3 * (a - 1)].w == corners_[3 * (b - 1)].w;
    const bool is_dense = is_one_object && std::min(height_px(a, p.x, view), height_px(b, q.x, view)) < rule.small_px;
    const float least = std::max(std::abs(p.x), std::abs(q.x)) * (is_dense || common == 1 ? rule.gap : kRounding);
    const bool is_before = bend_p < -least && bend_q > least, is_behind = bend_p > least && bend_q < -least;
    return {is_before, !is_before && !is_behind && !is_dense && common == 0, is_one_object};
}

IdReference::Edge IdReference::edge_at(const IdImage& image, glm::ivec2 at, const View& view, const Rule& rule) const
{
    bool ends = false, is_outline = false, meets = false;
    for (const glm::ivec2& way : {glm::ivec2(-1, 0), {1, 0}, {0, -1}, {0, 1}}) {
        const Crack found = crack(image, at, way, view, rule);
        ends |= found.ends;
        is_outline |= found.ends && !found.is_border;
        meets |= found.meets;
    }
    return {meets && !ends, ends, ends && !is_outline};
}

std::size_t IdReference::unlike(const Pixels& edge_map, const IdImage& image, const View& view, const Rule& rule) const
{
    std::size_t count = 0;
    for (int y = 0; y < image.size_px.y; ++y)
        for (int x = 0; x < image.size_px.x; ++x) {
            const std::uint8_t* rgb = edge_map.at(x, image.size_px.y - 1 - y);
            const Edge found{rgb[0] < kMarked, rgb[1] < kMarked, rgb[2] < kMarked};
            count += found == edge_at(image, {x, y}, view, rule) ? 0 : 1;
        }
    return count;
}

}  // namespace hw
