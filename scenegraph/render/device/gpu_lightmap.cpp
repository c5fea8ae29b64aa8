#include "hatchway/render/device/gpu_lightmap.hpp"

#include <glm/gtc/packing.hpp>

namespace hw {

void GpuLightmap::prepare()
{
    if (lightmap_ == nullptr || texture_.id() != 0) return;
    texture_ = GpuTexture({.format = TextureFormat::rgba16f, .size_px = lightmap_->size, .filter = FilterMode::linear});
    std::vector<glm::vec4> floats;  // what a texture of this format is filled from
    floats.reserve(lightmap_->luxels.size());
    for (const auto& halves : lightmap_->luxels)
        floats.emplace_back(glm::unpackHalf1x16(halves[0]), glm::unpackHalf1x16(halves[1]),
                            glm::unpackHalf1x16(halves[2]), 1.0f);
    texture_.upload(0, std::as_bytes(std::span(floats)));
    ++uploaded_count_;
}

SurfaceFeatures GpuLightmap::feature(ObjectId object) const
{
    if (lightmap_ == nullptr || lightmap_->places[object].sides == 0) return 0;
    return lightmap_->layouts[scene_.objects[object].mesh].is_per_vertex ? 2 : 1;
}

glm::vec4 GpuLightmap::place(ObjectId object) const
{
    const LightmapLayout& layout = lightmap_->layouts[scene_.objects[object].mesh];
    const std::size_t vertices = scene_.meshes[scene_.objects[object].mesh].positions.size();
    const bool has_back = lightmap_->places[object].sides == 2;
    const float to_back = !has_back              ? 0.0f
                          : layout.is_per_vertex ? static_cast<float>(vertices)
                                                 : static_cast<float>(layout.size.x);
    return {glm::vec2(lightmap_->places[object].corner), to_back, 0.0f};
}

}  // namespace hw
