#include "hatchway/render/frame_cost.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

#include "hatchway/render/view/covered_pixels.hpp"

namespace hw {
namespace {

// Measured with llvmpipe: a hidden face takes 4.5 ns for each of its pixels, asked about and drawn, at one sample.
constexpr double kLayersOfMask = 4.0;
constexpr double kLayersOfBlending = 20.0;
constexpr double kLayersOfImage = 4.0;
constexpr double kFewLayers = 0.01;             // of an object: it may be taken for as many as it can at most have
constexpr double kSmallPicture_px = 576'000.0;  // in smaller ones lines cost little however many lie over a pixel
constexpr double kLayersOfLine = 120.0;         // for each pixel along a line: it is some pixels wide

double layers_of(AlphaMode mode)
{
    if (mode == AlphaMode::blend) return kLayersOfBlending;
    return mode == AlphaMode::mask ? kLayersOfMask : 1.0;
}

/// How long the diagonal of a box is in the picture, pixels; that of the picture where the box reaches behind the eye.
double diagonal_px(const Box& box, const glm::mat4& clip_from_object, const glm::dvec2& size)
{
    glm::dvec2 low(size), high(0.0);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 place(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                              corner & 4 ? box.max.z : box.min.z);
        const glm::vec4 clip = clip_from_object * glm::vec4(place, 1.0f);
        if (clip.w <= 0.0f) return glm::length(size);
        const glm::dvec2 at = (glm::dvec2(clip) / static_cast<double>(clip.w) * 0.5 + 0.5) * size;
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    return std::min(glm::length(high - low), glm::length(size));
}

const Material& material_of(const LoadedScene& scene, const VisibleObject& object)
{
    return scene.input.scene->materials[scene.input.scene->objects[object.object].material];
}

double covered_by(const LoadedScene& scene, const VisibleSet& visible, std::size_t place, glm::ivec2 size_px)
{
    const VisibleObject& object = visible.objects[place];
    const auto ranges = std::span(visible.ranges).subspan(object.first_range, object.range_count);
    const float facing = material_of(scene, object).is_double_sided ? 0.0f : object.facing;
    const MeshData& mesh = scene.input.scene->meshes[scene.input.scene->objects[object.object].mesh];
    return covered_pixels(mesh, ranges, object.clip_from_object, facing, size_px);
}

}  // namespace

FrameCost frame_cost(const LoadedScene& scene, const VisibleSet& visible, std::size_t image_count, glm::ivec2 size_px)
{
    const double pixels = static_cast<double>(size_px.x) * size_px.y;
    std::vector<double> covered_px;
    double line_px = 0.0;
    for (const VisibleObject& object : visible.objects) {
        const int mesh = scene.input.scene->objects[object.object].mesh;
        const Box& bounds = scene.mesh_bounds[mesh];
        covered_px.push_back(most_covered_pixels(scene.mesh_areas[mesh], bounds, object.clip_from_object, size_px));
        const double diagonal = glm::length(bounds.size());
        if (diagonal > 0.0)
            line_px += scene.edges.line_length(object.object) / diagonal *
                       diagonal_px(bounds, object.clip_from_object, glm::dvec2(size_px));
    }
    // Most pictures are not deep whatever is in front of what. In others every triangle of what may be large is looked
    // at.
    const double most = std::accumulate(covered_px.begin(), covered_px.end(), 0.0);
    for (std::size_t i = 0; i < covered_px.size() && most > kDeepLayers * pixels; ++i)
        if (covered_px[i] > kFewLayers * pixels) covered_px[i] = covered_by(scene, visible, i, size_px);
    double weighted_px = 0.0;
    for (std::size_t i = 0; i < covered_px.size(); ++i)
        weighted_px += layers_of(material_of(scene, visible.objects[i]).alpha_mode) * covered_px[i];
    return {.face_layers = (1.0 + kLayersOfImage * static_cast<double>(image_count)) * weighted_px / pixels,
            .line_layers = kLayersOfLine * line_px / std::max(pixels, kSmallPicture_px)};
}

}  // namespace hw
