#include "hatchway/render/view/frame_block.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace hw {
namespace {

// The layout of HwFrame in shaders/frame.glsl, std140: matrices and four-vectors alone, so that nothing is padded.
struct FrameBlock {
    glm::mat4 view_from_world;
    glm::mat4 clip_from_view;
    glm::mat4 shadow_from_local;
    glm::vec4 eye_world_time;
    glm::vec4 eye_local;
    glm::vec4 to_viewer;
    glm::vec4 size_scale_focal;
    glm::vec4 exposure_near_far;
    glm::vec4 background_linear;
    glm::vec4 ambient_sky;
    glm::vec4 ambient_ground;
    glm::vec4 shadow_params;
    std::array<glm::vec4, kMaxLights> light_position;
    std::array<glm::vec4, kMaxLights> light_direction;
    std::array<glm::vec4, kMaxLights> light_colour;
    std::array<glm::vec4, kMaxLights> light_cone;
};

// Light from everywhere, as shares of a white picture: what the sky and the ground give in shade. Tied to the exposure,
// so that shade stays readable in every scene.
constexpr glm::vec3 kSkyShare{0.30f, 0.33f, 0.38f};
constexpr glm::vec3 kGroundShare{0.17f, 0.15f, 0.13f};
constexpr glm::vec3 kLuminanceWeights{0.2126f, 0.7152f, 0.0722f};
constexpr float kUnlitSceneGain = 2.2f;

double strength_at(const Light& light, const glm::dvec3& place)
{
    const double brightness = light.intensity * glm::max(light.colour.r, glm::max(light.colour.g, light.colour.b));
    if (light.type == LightType::sun) return 1e30 + brightness;
    const glm::dvec3 way = place - light.position_world;
    return brightness / std::max(glm::dot(way, way), 0.01);
}

void fill_light(FrameBlock& block, std::size_t i, const Light& light, const glm::dvec3& origin)
{
    block.light_position[i] = glm::vec4(glm::vec3(light.position_world - origin), static_cast<float>(light.type));
    block.light_direction[i] = glm::vec4(glm::vec3(glm::normalize(light.direction_world)), light.range_m);
    block.light_colour[i] = glm::vec4(light.colour, glm::dot(light.colour, kLuminanceWeights)) * light.intensity;
    const float inner = std::cos(light.inner_cone_rad);
    const float outer = std::cos(light.outer_cone_rad);
    const float scale = 1.0f / std::max(0.001f, inner - outer);
    block.light_cone[i] = glm::vec4(scale, -outer * scale, 0.0f, 0.0f);
}

/// Where positions count from that lights and shadows go by: the world's origin, or along each axis on which the eye is
/// far from it the eye. So a place on the globe is lit as one at the origin is.
glm::dvec3 local_origin(const glm::dvec3& eye_world)
{
    constexpr double kFar_m = 1024.0;  // floats step by a tenth of a millimetre there
    return {std::abs(eye_world.x) > kFar_m ? eye_world.x : 0.0, std::abs(eye_world.y) > kFar_m ? eye_world.y : 0.0,
            std::abs(eye_world.z) > kFar_m ? eye_world.z : 0.0};
}

glm::vec3 viewer_direction(const View& view)
{
    const double length = glm::length(view.to_viewer_world);
    return length > 0.0 ? glm::vec3(view.to_viewer_world / length) : glm::vec3(0.0f);
}

}  // namespace

glm::vec3 linear_from_srgb(const glm::vec3& srgb)
{
    const auto channel = [](float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); };
    return {channel(srgb.r), channel(srgb.g), channel(srgb.b)};
}

float focal_px(const View& view)
{
    return 0.5f * static_cast<float>(view.size_px.y) * view.clip_from_view[1][1];
}

glm::vec2 depth_range(const View& view)
{
    const double a = view.clip_from_view[2][2];
    const double b = view.clip_from_view[3][2];
    if (view.is_orthographic()) return {(b + 1.0) / a, (b - 1.0) / a};
    return {b / (a - 1.0), a < -1.0 ? b / (a + 1.0) : std::numeric_limits<float>::max()};
}

SceneLight choose_lights(std::span<const Light> lights, const Box& bounds_world)
{
    SceneLight result;
    result.lights.assign(lights.begin(), lights.end());
    const glm::dvec3 middle = bounds_world.is_empty() ? glm::dvec3(0.0) : bounds_world.centre();
    std::stable_sort(result.lights.begin(), result.lights.end(),
                     [&](const Light& a, const Light& b) { return strength_at(a, middle) > strength_at(b, middle); });
    if (result.lights.size() > kMaxLights) result.lights.resize(kMaxLights);
    if (!result.lights.empty() && result.lights[0].type == LightType::sun) result.main_light = 0;
    return result;
}

float white_luminance(float exposure_ev)
{
    return 1.2f * std::exp2(exposure_ev);
}

AmbientLight ambient_light(float exposure_ev, bool has_lights)
{
    const float white = white_luminance(exposure_ev) * (has_lights ? 1.0f : kUnlitSceneGain);
    return {kSkyShare * white, kGroundShare * white};
}

void stream_frame_block(GpuBuffer& buffer, const View& view, const SceneLight& light, const ShadowFrame& shadow)
{
    FrameBlock block{};
    const float exposure = 1.0f / white_luminance(light.exposure_ev);
    const glm::vec2 range = depth_range(view);
    const AmbientLight ambient = ambient_light(light.exposure_ev, !light.lights.empty());
    block.view_from_world = view.view_from_world;
    block.clip_from_view = view.clip_from_view;
    const glm::dvec3 origin = local_origin(view.eye_world);
    block.shadow_from_local = glm::mat4(glm::translate(shadow.shadow_from_world, origin));
    block.eye_world_time = glm::vec4(glm::vec3(view.eye_world), static_cast<float>(view.time_s));
    block.eye_local = glm::vec4(glm::vec3(view.eye_world - origin), 0.0f);
    block.to_viewer = glm::vec4(viewer_direction(view), 0.0f);
    block.size_scale_focal = glm::vec4(view.size_px, view.px_scale, focal_px(view));
    block.exposure_near_far = glm::vec4(exposure, range.x, range.y, view.is_orthographic() ? 1.0f : 0.0f);
    block.background_linear = glm::vec4(light.background_linear, 1.0f);
    block.ambient_sky = glm::vec4(ambient.sky_luminance, 0.0f);
    block.ambient_ground = glm::vec4(ambient.ground_luminance, 0.0f);
    block.shadow_params =
        glm::vec4(1.0f / shadow.size_px, shadow.texel_m, std::max(light.main_light, 0), shadow.is_drawn ? 1.0f : 0.0f);
    for (std::size_t i = 0; i < light.lights.size(); ++i) fill_light(block, i, light.lights[i], origin);
    buffer.stream(std::as_bytes(std::span(&block, 1)));
    buffer.bind_uniform_block(0);
}

}  // namespace hw
