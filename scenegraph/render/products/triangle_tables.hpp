#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

#include "hatchway/style/style.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// What shaders look up by the numbers of the image triangle_ids: triangle_ids.glsl reads it.
/// Source: Diktas, Sahiner. ID-Based Rendering of Silhouettes on GPU. 2011, sections 4.1 to 4.3.

/// Three entries a triangle, one for each corner, the triangles of all objects in the order of their numbers. xyz:
/// where the corner lies in the scene, in whole steps of 2^-32 of its longest side, so that corners are one where these
/// are. w: of the first corner the number of the object, from 1 on; of the second the bits of the triangle's least
/// height, metres; else 0.
std::vector<glm::uvec4> triangle_corners(const Scene& scene);

/// The triangles around each corner.
struct CornerStars {
    std::vector<glm::uvec2> of_corner;     ///< As triangle_corners(): first and count in `triangles`.
    std::vector<std::uint32_t> triangles;  ///< Numbers from 1 on, rising in each star. As many as there are corners.
};
CornerStars corner_stars(std::span<const glm::uvec4> corners);

/// Textures of tables are so wide: entry i is at (i % width, i / width).
inline constexpr int kTriangleTableWidth = 8192;

/// The images "triangle_corners" (rgba32ui), one output, and "triangle_stars" (rg32ui, r32ui), two. They are made once
/// for a scene. Throws hw::Error where the device has no texture large enough; `scene` must outlive the result's
/// prepare().
std::unique_ptr<ImagePass> triangle_corners_image(const Scene& scene);
std::unique_ptr<ImagePass> triangle_stars_image(const Scene& scene);

}  // namespace hw
