#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "hatchway/geometry/hatching/hatch_coordinates.hpp"
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

/// An object and the streams that its style asks for.
struct StreamUse {
    ObjectId object = 0;
    Streams streams;
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
    /// The object's mesh with `streams`, made when it is not there yet: vertices then stand once for each chart, or
    /// once for each triangle; triangles in the same order.
    StreamMesh mesh_of(ObjectId object, const Streams& streams);
    /// Computes on all threads what mesh_of() will need for such uses. Touches no device: for any thread, while nothing
    /// else is called here.
    void prepare(std::span<const StreamUse> uses);
    int hatch_streams_built() const { return static_cast<int>(stream_meshes_.size()); }
    const GpuMaterial& material_of(ObjectId object) const { return materials_[scene_.objects[object].material]; }
    const GpuMap& map(int index);
    /// How many triangles the objects before this one have: where the numbers of its own begin.
    int first_triangle(ObjectId object) const { return first_triangle_[object]; }

 private:
    /// A mesh with streams of its own.
    struct StreamKey {
        int mesh;
        std::optional<HatchSource> source;  ///< None: no coordinates that strokes follow.
        bool is_loose;                      ///< Three vertices of its own for each triangle.
        auto operator<=>(const StreamKey&) const = default;
    };

    bool makes_uv(ObjectId object, const Streams& streams) const;
    /// None where the mesh itself has all that is asked for.
    std::optional<StreamKey> key_of(ObjectId object, const Streams& streams) const;
    HatchCoordinates coordinates(const StreamKey& key) const;
    std::uint32_t texture(const TextureUse& use, bool is_srgb);
    GpuMaterial upload(const Material& material);

    const Scene& scene_;
    FilterMode texture_filter_;
    std::vector<const MapLevels*> maps_;
    std::vector<GpuMesh> meshes_;
    std::map<StreamKey, GpuMesh> stream_meshes_;
    std::map<StreamKey, HatchCoordinates> prepared_;  ///< Of meshes that are not on the device yet.
    std::vector<int> first_triangle_;                 ///< Of each object.
    std::vector<GpuMaterial> materials_;
    std::vector<std::optional<GpuMap>> gpu_maps_;
    std::map<std::pair<int, bool>, GpuTexture> textures_;
};

}  // namespace hw
