#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "hatchway/gl/gpu_buffer.hpp"
#include "hatchway/gl/gpu_texture.hpp"
#include "hatchway/maps/map_levels.hpp"
#include "hatchway/render/device/program_store.hpp"
#include "hatchway/style/needs.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// A mesh on the device.
struct GpuMesh {
    GpuBuffer vertices;
    GpuBuffer indices;
    GpuVertexArray array;
    SurfaceFeatures features = 0;  ///< Its vertex streams.
    float metres_per_uv = 1.0f;    ///< How far a unit of uv0 reaches on the surface, object space, at the median.
    std::uint32_t index_count = 0;
    // Three vertices of its own for each triangle, for triangle ids. Made when an image of them is asked for.
    GpuBuffer loose_vertices;
    GpuVertexArray loose_array;
};

/// A material on the device: ids of textures, 0 where there is none.
struct GpuMaterial {
    const Material* facts = nullptr;
    SurfaceFeatures features = 0;
    std::uint32_t base_colour = 0;
    std::uint32_t metallic_roughness = 0;
    std::uint32_t normal = 0;
    std::uint32_t occlusion = 0;
    std::uint32_t emissive = 0;
    glm::vec3 mean_colour{1.0f};  ///< Of the base colour and its texture, linear.
};

struct GpuMap {
    GpuTexture texture;
    glm::vec4 info{1.0f};  ///< hw_..._info of surface.glsl.
};

/// A mesh with the streams that a style asks for.
struct StreamMesh {
    const GpuMesh* mesh = nullptr;
    SurfaceFeatures features = 0;  ///< Of the mesh and of the streams.
};

/// What the device holds of a scene. Meshes are uploaded at once, maps when named, textures with their materials.
class GpuScene {
 public:
    /// `texture_filter` is that of materials' textures.
    GpuScene(const Scene& scene, const std::vector<const MapLevels*>& maps, FilterMode texture_filter);

    const GpuMesh& mesh(int index) const { return meshes_[index]; }
    const GpuMaterial& material(int index) const { return materials_[index]; }
    const GpuMesh& mesh_of(ObjectId object) const { return meshes_[scene_.objects[object].mesh]; }
    /// The object's mesh with `streams`, made when it is not there yet: vertices then stand once for each chart,
    /// triangles in the same order.
    StreamMesh mesh_of(ObjectId object, const Streams& streams);
    int hatch_streams_built() const { return static_cast<int>(hatch_meshes_.size()); }
    const GpuMaterial& material_of(ObjectId object) const { return materials_[scene_.objects[object].material]; }
    const GpuMap& map(int index);
    /// The mesh with loose vertices for triangle ids.
    const GpuMesh& loose_mesh(int index);

 private:
    std::uint32_t texture(const TextureUse& use, bool is_srgb);
    GpuMaterial upload(const Material& material);

    const Scene& scene_;
    FilterMode texture_filter_;
    std::vector<const MapLevels*> maps_;
    std::vector<GpuMesh> meshes_;
    std::map<std::pair<int, HatchSource>, GpuMesh> hatch_meshes_;
    std::vector<GpuMaterial> materials_;
    std::vector<std::optional<GpuMap>> gpu_maps_;
    std::map<std::pair<int, bool>, GpuTexture> textures_;
};

}  // namespace hw
