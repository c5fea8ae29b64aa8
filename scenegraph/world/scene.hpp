#pragma once

#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "hatchway/core/box.hpp"
#include "hatchway/core/pixels.hpp"
#include "hatchway/geometry/mesh_data.hpp"

namespace hw {

inline constexpr int kNone = -1;  ///< No node, mesh, material, texture or image.

/// A place in the tree of the model. Parents stand before their children.
struct Node {
    std::string name;  ///< As the model states it; may be empty, need not be unique.
    std::string path;  ///< Names from the root joined by '/', unnamed nodes as "#index".
    int parent = kNone;
    glm::dmat4 local{1.0};  ///< Parent from node.
    glm::dmat4 world_from_node{1.0};
    bool is_animated = false;          ///< It or a parent is moved by an animation of the model.
    std::optional<std::string> style;  ///< glTF extras.hatchway.style
    std::optional<float> certainty;    ///< glTF extras.hatchway.certainty, in [0, 1].
};

enum class TextureWrap : unsigned char { repeat, mirrored_repeat, clamp };

/// A texture: an image and how it is sampled.
struct Texture {
    int image = kNone;
    TextureWrap wrap_u = TextureWrap::repeat;
    TextureWrap wrap_v = TextureWrap::repeat;
    bool is_nearest = false;  ///< Magnified without filtering.
};

/// A material's use of a texture.
struct TextureUse {
    int texture = kNone;
    int uv_set = 0;                ///< 0 or 1.
    glm::mat3 uv_transform{1.0f};  ///< KHR_texture_transform: applied to (u, v, 1).
};

enum class AlphaMode : unsigned char { opaque, mask, blend };

/// glTF's metallic-roughness material. Colours are linear.
struct Material {
    std::string name;
    glm::vec4 base_colour{1.0f};
    TextureUse base_colour_texture;  ///< sRGB
    float metallic = 1.0f;
    float roughness = 1.0f;
    TextureUse metallic_roughness_texture;  ///< Linear; roughness in G, metallic in B.
    TextureUse normal_texture;              ///< Linear, tangent space.
    float normal_scale = 1.0f;
    TextureUse occlusion_texture;  ///< Linear, R.
    float occlusion_strength = 1.0f;
    glm::vec3 emissive{0.0f};
    TextureUse emissive_texture;  ///< sRGB
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5f;
    bool is_double_sided = false;
    bool is_unlit = false;
};

enum class LightType : unsigned char { sun, point, spot };

/// KHR_lights_punctual, in world space. Colour is linear.
struct Light {
    std::string name;
    LightType type = LightType::point;
    glm::vec3 colour{1.0f};
    float intensity = 1.0f;  ///< Lux for a sun, candela for point and spot lights.
    glm::dvec3 position_world{0.0};
    glm::dvec3 direction_world{0.0, -1.0, 0.0};  ///< Unit, from the light to what it lights.
    float range_m = 0.0f;                        ///< 0: unlimited.
    float inner_cone_rad = 0.0f;
    float outer_cone_rad = 0.785398f;
};

/// A viewpoint, in world space.
struct Camera {
    std::string name;
    glm::dvec3 eye_world{0.0};
    glm::dvec3 target_world{0.0, 0.0, -1.0};
    double fov_deg = 60.0;  ///< Vertical.
    /// A parallel projection so high, metres; then the angle says nothing. What is behind the eye is not seen.
    std::optional<double> orthographic_height_m;
    double roll_deg = 0.0;  ///< About the line of sight: see picture_up().
};

/// Index into Scene::objects.
using ObjectId = std::uint32_t;

/// What is drawn and styled: one node's use of one primitive of a mesh.
struct Object {
    int node = kNone;
    int mesh = kNone;      ///< Index into Scene::meshes; instances share it.
    int material = kNone;  ///< Index into Scene::materials; never kNone, the importer adds glTF's default material.
    int place = kNone;     ///< Index into Scene::places; kNone: where its node is.
    Box bounds_world;
};

/// A model as loaded: no styles, no visibility, no GL.
struct Scene {
    std::string file;
    std::vector<Node> nodes;
    std::vector<MeshData> meshes;  ///< One for each glTF primitive (of triangles) that is used.
    /// Of objects whose mesh was brought near its origin (io/model/settle_meshes.hpp).
    std::vector<glm::dmat4> places;
    std::uint32_t turned_triangles = 0;    ///< Of all meshes: wound against the rest of their component in the file.
    std::uint32_t left_out_triangles = 0;  ///< Of meshes that show both sides: had the corners of another one.
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<Pixels> images;
    std::vector<Light> lights;
    std::vector<Camera> cameras;
    std::vector<Object> objects;        ///< In the order of nodes, then primitives.
    std::map<ObjectId, Object> hidden;  ///< What objects were before hide_objects() emptied them.
    Box bounds_world;
    std::vector<std::string> doubts;  ///< What the model says and the importer does not understand, for `check`.

    const glm::dmat4& world_from_object(ObjectId id) const
    {
        const Object& object = objects[id];
        return object.place == kNone ? nodes[object.node].world_from_node : places[object.place];
    }
};

/// Drawn triangles of all objects: instances count each time.
std::uint64_t drawn_triangle_count(const Scene& scene);

}  // namespace hw
