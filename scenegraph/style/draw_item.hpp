#pragma once

#include <cstdint>
#include <span>

#include "hatchway/world/presence.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// One visible object in the hands of a style. Plain facts for choosing programs and uniforms; the host binds geometry,
/// material, maps, lights and presence by itself when the item is drawn.
struct DrawItem {
    ObjectId object = 0;
    const MeshData* mesh = nullptr;
    const Material* material = nullptr;
    glm::mat4 world_from_object{1.0f};
    Box bounds_world;  ///< Of the object.
    PresenceField presence;
    bool is_presence_inverted = false;  ///< The style shows 1 - presence: another style of the object shows presence.
    float certainty = 1.0f;             ///< Of the level, in [0, 1]: a free variable for colour or tone.
    std::uint32_t slot = 0;             ///< The host's own index of the item.
};

/// Objects that one call draws; valid during that call.
using Items = std::span<const DrawItem>;

/// Opaque and masked faces are drawn before blended ones.
enum class Layer : std::uint8_t { opaque, blended };

}  // namespace hw
