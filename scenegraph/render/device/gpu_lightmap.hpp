#pragma once

#include <glm/vec4.hpp>

#include "hatchway/gl/gpu_texture.hpp"
#include "hatchway/render/device/program_store.hpp"
#include "hatchway/world/light/lightmap.hpp"

namespace hw {

/// Baked light on the device, uploaded when something that is drawn first reads it.
class GpuLightmap {
 public:
    /// `lightmap` may be null: no object has baked light then. Else it and the scene must outlive this.
    GpuLightmap(const Lightmap* lightmap, const Scene& scene) : lightmap_(lightmap), scene_(scene) {}

    /// Whether there is light to read.
    bool has_light() const { return lightmap_ != nullptr; }
    /// Uploads the atlas when it is not there yet.
    void prepare();

    std::uint32_t texture() const { return texture_.id(); }
    int uploaded_count() const { return uploaded_count_; }
    /// surface_feature::kLightmapBit's value, for an object.
    SurfaceFeatures feature(ObjectId object) const;
    /// hw_lightmap_place of surface.vert and baked.glsl.
    glm::vec4 place(ObjectId object) const;

 private:
    const Lightmap* lightmap_;
    const Scene& scene_;
    GpuTexture texture_;
    int uploaded_count_ = 0;
};

}  // namespace hw
