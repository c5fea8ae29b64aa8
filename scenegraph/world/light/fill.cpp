#include "hatchway/world/light/fill.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <limits>

#include "hatchway/world/light/material.hpp"

namespace hw {
namespace {

constexpr int kFillSteps = 3;  // a picture's point blends no luxel further inside of a solid
constexpr int kVertexFillSteps = 8;
constexpr std::uint32_t kNoLuxel = 0xffffffffu;

/// The luxels of charts by where they stand.
class LuxelGrid {
 public:
    LuxelGrid(const std::vector<Luxel>& luxels, const Lightmap& lightmap, const std::vector<bool>& is_charted)
        : luxels_(luxels), size_(lightmap.size), at_(lightmap.luxels.size(), kNoLuxel)
    {
        for (std::uint32_t i = 0; i < luxels.size(); ++i)
            if (is_charted[luxels[i].object]) at_[luxels[i].place] = i;
    }
    /// The luxel of the same chart `step` away from luxel i; kNoLuxel: none.
    std::uint32_t at(std::uint32_t i, glm::ivec2 step) const
    {
        const int width = size_.x;
        const glm::ivec2 place = glm::ivec2(luxels_[i].place % width, luxels_[i].place / width) + step;
        if (place.x < 0 || place.y < 0 || place.x >= size_.x || place.y >= size_.y) return kNoLuxel;
        const std::uint32_t other = at_[static_cast<std::size_t>(place.y) * width + place.x];
        return other != kNoLuxel && luxels_[other].chart == luxels_[i].chart ? other : kNoLuxel;
    }
    template <typename Visit>
    void visit_neighbours(std::uint32_t i, const Visit& visit) const
    {
        if (at_[luxels_[i].place] != i) return;
        const glm::ivec2 middle(static_cast<int>(luxels_[i].place) % size_.x,
                                static_cast<int>(luxels_[i].place) / size_.x);
        for (int y = std::max(0, middle.y - 1); y <= std::min(size_.y - 1, middle.y + 1); ++y)
            for (int x = std::max(0, middle.x - 1); x <= std::min(size_.x - 1, middle.x + 1); ++x) {
                const std::uint32_t other = at_[static_cast<std::size_t>(y) * size_.x + x];
                if (other == kNoLuxel || other == i || luxels_[other].chart != luxels_[i].chart) continue;
                visit(other);
            }
    }

 private:
    const std::vector<Luxel>& luxels_;
    glm::ivec2 size_;
    std::vector<std::uint32_t> at_;
};

using LuxelPair = std::pair<std::uint32_t, std::uint32_t>;

void carry_on_over_edges(const LuxelGrid& grid, const GatheredLight& gathered, std::span<const LuxelPair> parted,
                         std::vector<glm::vec3>& light)
{
    for (std::uint32_t i = 0; i < light.size(); ++i) {
        const glm::ivec2 step = gathered.places[i].mirrored;
        if (step == glm::ivec2(0)) continue;
        const std::uint32_t inner = grid.at(i, step);
        if (inner == kNoLuxel || gathered.places[inner].is_buried || gathered.places[i].is_buried) continue;
        if (std::binary_search(parted.begin(), parted.end(), LuxelPair(std::min(i, inner), std::max(i, inner))))
            continue;
        const glm::vec3 edge = gathered.illuminance[i];
        light[i] = glm::clamp(2.0f * edge - gathered.illuminance[inner], glm::vec3(0.0f), 2.0f * edge);
    }
}

std::vector<bool> known_luxels(const GatheredLight& gathered)
{
    std::vector<bool> is_known;
    for (const LuxelPlace& place : gathered.places) is_known.push_back(!place.is_buried);
    return is_known;
}

void fill_charts(const LuxelGrid& grid, std::vector<bool>& is_known, std::vector<glm::vec3>& light)
{
    for (int step = 0; step < kFillSteps; ++step) {
        std::vector<std::pair<std::uint32_t, glm::vec3>> found;
        for (std::uint32_t i = 0; i < light.size(); ++i) {
            if (is_known[i]) continue;
            float darkest = std::numeric_limits<float>::infinity();
            glm::vec3 value(0.0f);
            grid.visit_neighbours(i, [&](std::uint32_t other) {
                if (!is_known[other] || luminance_of(light[other]) >= darkest) return;
                darkest = luminance_of(light[other]);
                value = light[other];
            });
            if (darkest < std::numeric_limits<float>::infinity()) found.emplace_back(i, value);
        }
        for (const auto& [i, value] : found) {
            light[i] = value;
            is_known[i] = true;
        }
    }
}

/// Fills the vertices of the luxels [first, last), all of one side of one object.
void fill_vertices(const MeshData& mesh, std::span<const Luxel> luxels, std::vector<bool>& is_known,
                   std::vector<glm::vec3>& light, std::size_t first)
{
    std::vector<std::uint32_t> luxel_of(mesh.positions.size(), kNoLuxel);
    for (std::size_t i = 0; i < luxels.size(); ++i)
        luxel_of[static_cast<std::size_t>(luxels[i].at.x)] = static_cast<std::uint32_t>(first + i);
    for (int step = 0; step < kVertexFillSteps; ++step) {
        std::vector<glm::vec4> sums(luxels.size(), glm::vec4(0.0f));
        for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t to = luxel_of[mesh.indices[t * 3 + k]];
                const std::uint32_t from = luxel_of[mesh.indices[t * 3 + (k + 1) % 3]];
                if (is_known[from] && !is_known[to]) sums[to - first] += glm::vec4(light[from], 1.0f);
                if (is_known[to] && !is_known[from]) sums[from - first] += glm::vec4(light[to], 1.0f);
            }
        for (std::size_t i = 0; i < sums.size(); ++i) {
            if (sums[i].w <= 0.0f) continue;
            light[first + i] = glm::vec3(sums[i]) / sums[i].w;
            is_known[first + i] = true;
        }
    }
}

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> parted_luxels(const LuxelPoints& points,
                                                                   std::span<const LuxelPlace> places,
                                                                   const Lightmap& lightmap)
{
    const std::vector<Luxel>& luxels = points.luxels();
    const LuxelGrid grid(luxels, lightmap, points.charted_objects());
    std::vector<std::vector<std::uint32_t>> parted(luxels.size());
    tbb::parallel_for(std::size_t{0}, luxels.size(), [&](std::size_t i) {
        const auto self = static_cast<std::uint32_t>(i);
        if (places[i].is_buried) return;
        grid.visit_neighbours(self, [&](std::uint32_t other) {
            if (other < self || places[other].is_buried) return;
            if (!places[i].is_near_wall && !places[other].is_near_wall) return;
            if (points.are_parted(places[i], places[other])) parted[i].push_back(other);
        });
    });
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::uint32_t i = 0; i < luxels.size(); ++i)
        for (const std::uint32_t other : parted[i]) pairs.emplace_back(i, other);
    return pairs;
}

std::vector<glm::vec3> filled_light(const GatheredLight& gathered, const Scene& scene, const Lightmap& lightmap,
                                    std::span<const std::pair<std::uint32_t, std::uint32_t>> parted)
{
    const std::vector<Luxel>& luxels = gathered.points.luxels();
    std::vector<glm::vec3> light(gathered.illuminance.begin(), gathered.illuminance.end());
    const std::vector<bool> is_charted = gathered.points.charted_objects();
    const LuxelGrid grid(luxels, lightmap, is_charted);
    carry_on_over_edges(grid, gathered, parted, light);
    const auto darken = [&](std::uint32_t to, std::uint32_t from) {
        if (luminance_of(gathered.illuminance[from]) < luminance_of(light[to])) light[to] = gathered.illuminance[from];
    };
    for (const auto& [a, b] : parted) {
        darken(a, b);
        darken(b, a);
    }
    std::vector<bool> is_known = known_luxels(gathered);
    fill_charts(grid, is_known, light);
    for (std::size_t first = 0; first < luxels.size();) {
        std::size_t last = first;
        while (last < luxels.size() && luxels[last].object == luxels[first].object &&
               luxels[last].is_back == luxels[first].is_back)
            ++last;
        if (!is_charted[luxels[first].object])
            fill_vertices(scene.meshes[scene.objects[luxels[first].object].mesh],
                          std::span(luxels).subspan(first, last - first), is_known, light, first);
        first = last;
    }
    return light;
}

}  // namespace hw
