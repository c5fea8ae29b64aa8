#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "hatchway/core/box.hpp"
#include "hatchway/world/presence.hpp"

namespace hw {

struct MeshFacts {
    std::uint32_t vertices = 0;
    std::uint32_t triangles = 0;
    bool has_uv = false;
    bool has_colours = false;
};

/// Of a glTF material; colours linear, without its textures.
struct MaterialFacts {
    glm::vec4 base_colour{1.0f};
    glm::vec3 emissive{0.0f};
    float metallic = 1.0f;
    float roughness = 1.0f;
    bool has_base_colour_map = false;
    bool is_masked = false;
    bool is_blended = false;
    bool is_double_sided = false;
    bool is_unlit = false;
};

/// What a style may choose programs and uniforms by.
struct ItemFacts {
    std::uint32_t object = 0;  ///< Its number in the scene, the same in every frame.
    MeshFacts mesh;
    MaterialFacts material;
    glm::mat4 world_from_object{1.0f};
    Box bounds_world;
    float certainty = 1.0f;  ///< Of the level, in [0, 1]: a free variable for colour or tone.
};

/// A handle of one visible object. The host makes it, binds geometry, material, maps, lights and presence by itself
/// when it is drawn, and draws it in its own frame alone: one that was kept over frames, made by a style or never set
/// is refused, which the log says once for each style.
class DrawItem {
 public:
    DrawItem() = default;

    std::uint32_t object() const { return facts_.object; }
    const MeshFacts& mesh() const { return facts_.mesh; }
    const MaterialFacts& material() const { return facts_.material; }
    const glm::mat4& world_from_object() const { return facts_.world_from_object; }
    const Box& bounds_world() const { return facts_.bounds_world; }
    float certainty() const { return facts_.certainty; }

 private:
    friend class FrameItems;

    ItemFacts facts_;
    PresenceField presence_;             // the share that the style has in the object
    bool is_presence_inverted_ = false;  // another style of the object shows presence_, this one the rest
    std::uint32_t slot_ = 0;
    std::uint64_t frame_ = 0;  // 0: of none
};

/// Objects that one call draws; valid during that call.
using Items = std::span<const DrawItem>;

/// Opaque and masked faces are drawn before blended ones.
enum class Layer : std::uint8_t { opaque, blended };

}  // namespace hw
