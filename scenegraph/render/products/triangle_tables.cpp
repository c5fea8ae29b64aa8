#include "hatchway/render/products/triangle_tables.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <tuple>

#include "hatchway/gl/gpu_texture.hpp"

namespace hw {
namespace {

/// Positions of the scene as whole numbers.
class Grid {
 public:
    explicit Grid(const Box& bounds)
    {
        if (bounds.is_empty()) return;
        const glm::dvec3 size = bounds.size();
        const double longest = std::max({size.x, size.y, size.z});
        low_ = bounds.min;
        steps_per_metre_ = longest > 0.0 ? 4294967295.0 / longest : 0.0;
    }
    glm::uvec3 at(const glm::dvec3& world) const
    {
        const glm::dvec3 steps = glm::floor((world - low_) * steps_per_metre_ + 0.5);
        return glm::uvec3(glm::clamp(steps, 0.0, 4294967295.0));
    }

 private:
    glm::dvec3 low_{0.0};
    double steps_per_metre_ = 0.0;
};

float least_height(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const double twice_area = glm::length(glm::cross(b - a, c - a));
    const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    return longest > 0.0 ? static_cast<float>(twice_area / longest) : 0.0f;
}

template <typename Entry>
GpuTexture table_texture(std::vector<Entry> entries, TextureFormat format)
{
    const int rows = std::max(1, static_cast<int>((entries.size() + kTriangleTableWidth - 1) / kTriangleTableWidth));
    GpuTexture texture({.format = format, .size_px = {kTriangleTableWidth, rows}, .filter = FilterMode::nearest});
    entries.resize(static_cast<std::size_t>(rows) * kTriangleTableWidth);
    texture.upload(0, std::as_bytes(std::span(entries)));
    return texture;
}

/// Tables of whole numbers that stay as they are.
class TableImage : public ImagePass {
 public:
    explicit TableImage(const Scene& scene) : scene_(scene) {}
    Needs needs() const override { return {}; }
    Images make(Pass&, Items) override { return images_; }

 protected:
    void add(GpuTexture texture, PixelFormat format)
    {
        images_.add({texture.id(), texture.desc().size_px, format});
        textures_.push_back(std::move(texture));
    }
    bool is_made() const { return !textures_.empty(); }

    const Scene& scene_;

 private:
    std::vector<GpuTexture> textures_;
    Images images_;
};

struct CornersImage final : TableImage {
    using TableImage::TableImage;
    void prepare(ProgramCache&) override
    {
        if (!is_made()) add(table_texture(triangle_corners(scene_), TextureFormat::rgba32ui), PixelFormat::rgba32ui);
    }
};

struct StarsImage final : TableImage {
    using TableImage::TableImage;
    void prepare(ProgramCache&) override
    {
        if (is_made()) return;
        CornerStars stars = corner_stars(triangle_corners(scene_));
        add(table_texture(std::move(stars.of_corner), TextureFormat::rg32ui), PixelFormat::rg32ui);
        add(table_texture(std::move(stars.triangles), TextureFormat::r32ui), PixelFormat::r32ui);
    }
};

}  // namespace

std::vector<glm::uvec4> triangle_corners(const Scene& scene)
{
    const Grid grid(scene.bounds_world);
    std::vector<glm::uvec4> corners;
    corners.reserve(3 * drawn_triangle_count(scene));
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const MeshData& mesh = scene.meshes[scene.objects[id].mesh];
        const glm::dmat4& to_world = scene.world_from_object(id);
        std::vector<glm::dvec3> world;
        for (const glm::vec3& p : mesh.positions) world.emplace_back(to_world * glm::dvec4(p, 1.0));
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const glm::dvec3 &a = world[mesh.indices[i]], &b = world[mesh.indices[i + 1]],
                             &c = world[mesh.indices[i + 2]];
            corners.emplace_back(grid.at(a), id + 1);
            corners.emplace_back(grid.at(b), std::bit_cast<std::uint32_t>(least_height(a, b, c)));
            corners.emplace_back(grid.at(c), 0u);
        }
    }
    return corners;
}

CornerStars corner_stars(std::span<const glm::uvec4> corners)
{
    const auto place = [&](std::uint32_t i) { return std::tie(corners[i].x, corners[i].y, corners[i].z); };
    std::vector<std::uint32_t> order(corners.size());
    std::iota(order.begin(), order.end(), 0u);
    tbb::parallel_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return place(a) != place(b) ? place(a) < place(b) : a < b;
    });
    CornerStars stars;
    stars.of_corner.resize(corners.size());
    stars.triangles.reserve(corners.size());
    for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
        while (end < order.size() && place(order[end]) == place(order[first])) ++end;
        for (std::size_t i = first; i < end; ++i) {
            stars.of_corner[order[i]] = glm::uvec2(first, end - first);
            stars.triangles.push_back(order[i] / 3 + 1);
        }
    }
    return stars;
}

std::unique_ptr<ImagePass> triangle_corners_image(const Scene& scene)
{
    return std::make_unique<CornersImage>(scene);
}

std::unique_ptr<ImagePass> triangle_stars_image(const Scene& scene)
{
    return std::make_unique<StarsImage>(scene);
}

}  // namespace hw
