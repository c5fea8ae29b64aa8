#include "hatchway/world/light/lightmap.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "hatchway/core/error.hpp"
#include "hatchway/geometry/vertex_streams.hpp"

namespace hw {
namespace {

constexpr float kLuxPerUnit = 1000.0f;

/// The luxels around a place of the atlas, bilinear.
std::vector<BlendedLuxel> blended_at(const Lightmap& lightmap, const glm::vec2& uv)
{
    const glm::vec2 from = uv - 0.5f;
    const glm::ivec2 low(glm::floor(from));
    const glm::vec2 share = from - glm::vec2(low);
    std::vector<BlendedLuxel> result;
    for (int corner = 0; corner < 4; ++corner) {
        const glm::ivec2 step(corner & 1, corner >> 1);
        const glm::vec2 weight(step.x ? share.x : 1.0f - share.x, step.y ? share.y : 1.0f - share.y);
        const glm::ivec2 at = glm::clamp(low + step, glm::ivec2(0), lightmap.size - 1);
        result.push_back({static_cast<std::uint32_t>(at.y * lightmap.size.x + at.x), weight.x * weight.y});
    }
    return result;
}

template <typename Stream>
void append_copies(Stream& stream, const std::vector<std::uint32_t>& copied)
{
    if (stream.empty()) return;
    stream.reserve(stream.size() + copied.size());
    for (const std::uint32_t vertex : copied) stream.push_back(stream[vertex]);
}

}  // namespace

std::vector<BlendedLuxel> blended_luxels(const Lightmap& lightmap, const Scene& scene, const SurfacePoint& point)
{
    const LightmapPlace& place = lightmap.places[point.object];
    if (place.sides == 0) return {};
    const int mesh_index = scene.objects[point.object].mesh;
    const MeshData& mesh = scene.meshes[mesh_index];
    const LightmapLayout& layout = lightmap.layouts[mesh_index];
    const bool is_back = point.is_back && place.sides == 2;
    if (layout.is_per_vertex) {
        const auto first = static_cast<std::uint32_t>(place.corner.y * lightmap.size.x + place.corner.x) +
                           (is_back ? static_cast<std::uint32_t>(mesh.positions.size()) : 0u);
        std::vector<BlendedLuxel> result;
        for (int corner = 0; corner < 3; ++corner)
            result.push_back({first + mesh.indices[point.triangle * 3 + corner], point.barycentric[corner]});
        return result;
    }
    glm::vec2 uv = glm::vec2(place.corner) + glm::vec2(is_back ? layout.size.x : 0, 0);
    for (int corner = 0; corner < 3; ++corner)
        uv += point.barycentric[corner] * layout.uv[layout.indices[point.triangle * 3 + corner]];
    return blended_at(lightmap, uv);
}

glm::vec3 luxel_illuminance(const Lightmap& lightmap, std::uint32_t luxel)
{
    const auto& halves = lightmap.luxels[luxel];
    return kLuxPerUnit *
           glm::vec3(glm::unpackHalf1x16(halves[0]), glm::unpackHalf1x16(halves[1]), glm::unpackHalf1x16(halves[2]));
}

glm::vec3 baked_illuminance(const Lightmap& lightmap, const Scene& scene, const SurfacePoint& point)
{
    glm::vec3 sum(0.0f);
    for (const BlendedLuxel& blended : blended_luxels(lightmap, scene, point))
        sum += blended.share * luxel_illuminance(lightmap, blended.luxel);
    return sum;
}

void add_lightmap_stream(MeshData& mesh, const LightmapLayout& layout)
{
    if (layout.is_empty() || layout.is_per_vertex) return;
    HW_ASSERT(layout.indices.size() == mesh.indices.size());
    HW_ASSERT(layout.uv.size() == mesh.positions.size() + layout.copied_vertices.size());
    for_each_stream(mesh, [&](auto& stream) { append_copies(stream, layout.copied_vertices); });
    mesh.indices = layout.indices;
    mesh.lightmap_uv = layout.uv;
}

}  // namespace hw
