#pragma once

#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

#include "hatchway/gl/gpu_buffer.hpp"
#include "hatchway/style/view.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

inline constexpr int kMaxLights = 8;  ///< As in shaders/frame.glsl.

/// The light of a scene as shaders see it.
struct SceneLight {
    std::vector<Light> lights;  ///< At most kMaxLights; suns first, the main light before all.
    int main_light = kNone;     ///< The strongest sun: the one that casts a shadow.
    float exposure_ev = 0.0f;
    glm::vec3 background_linear{1.0f};
};

/// Light from everywhere, cd/m^2.
struct AmbientLight {
    glm::vec3 sky_luminance{0.0f};
    glm::vec3 ground_luminance{0.0f};
};

/// What a frame takes for the light of sky and ground: shares of a white picture, so that shade stays readable in every
/// scene; more of it where nothing else shines.
AmbientLight ambient_light(float exposure_ev, bool has_lights);

/// The luminance that an exposure shows as white.
float white_luminance(float exposure_ev);

/// Chooses the lights that shaders get: all suns first, then by how much they light the middle of `bounds_world`.
/// Depends on the scene alone, so that pictures do not depend on the viewer's way.
SceneLight choose_lights(std::span<const Light> lights, const Box& bounds_world);

/// The main light's shadow map, when there is one.
struct ShadowFrame {
    bool is_drawn = false;
    glm::dmat4 shadow_from_world{1.0};
    float size_px = 1.0f;
    float texel_m = 0.0f;
};

/// Fills the uniform block HwFrame (shaders/frame.glsl).
void stream_frame_block(GpuBuffer& block, const View& view, const SceneLight& light, const ShadowFrame& shadow);

glm::vec3 linear_from_srgb(const glm::vec3& srgb);

/// Pixels that a thing of unit slope spans: half the picture's height over the tangent of half the field of view. In a
/// parallel projection the pixels of a metre.
float focal_px(const View& view);
/// Distances of the near and far plane, read from the projection; the largest float where there is no far plane.
glm::vec2 depth_range(const View& view);

}  // namespace hw
