#pragma once

#include "hatchway/world/scene.hpp"

namespace hw {

/// A material's colour where the vertices and barycentric weights say. Textures by nearest texel.
struct MaterialPoint {
    const Scene& scene;
    int mesh = kNone;
    int material = kNone;
    std::uint32_t triangle = 0;
    glm::vec3 barycentric{1.0f, 0.0f, 0.0f};
};

/// Base colour, linear, and alpha: factor, texture and vertex colour.
glm::vec4 base_colour_at(const MaterialPoint& point);

/// Emission, linear: factor and texture.
glm::vec3 emission_at(const MaterialPoint& point);

/// Luminance of a material's emission, mean over its texture.
float mean_emission(const Scene& scene, const Material& material);

/// Luminance of a linear colour.
inline float luminance_of(const glm::vec3& colour)
{
    return 0.2126f * colour.r + 0.7152f * colour.g + 0.0722f * colour.b;
}

}  // namespace hw
