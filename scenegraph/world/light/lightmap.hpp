#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "hatchway/world/scene.hpp"

namespace hw {

/// How a mesh lies in a lightmap; all instances of the mesh share it. Empty: no instance of the mesh is lit.
struct LightmapLayout {
    bool is_per_vertex = false;                  ///< A luxel for each vertex; nothing else is set then.
    std::vector<std::uint32_t> copied_vertices;  ///< Vertices that stand in two charts: what follows the mesh's own.
    std::vector<std::uint32_t> indices;          ///< As MeshData::indices, copies used.
    std::vector<glm::vec2> uv;                   ///< Of each vertex, then of each copy; in luxels from the corner.
    glm::ivec2 size{0};                          ///< Luxels that the charts take with their borders.

    bool is_empty() const { return !is_per_vertex && indices.empty(); }
    bool operator==(const LightmapLayout&) const = default;
};

/// Where an object's luxels stand in the atlas.
struct LightmapPlace {
    std::uint8_t sides = 0;  ///< 0: the object has no baked light; 2: double-sided, the back stands right of the front.
    glm::ivec2 corner{0};  ///< Of its rectangle. Per vertex: the first luxel; more follow to the right, row after row.
    bool operator==(const LightmapPlace&) const = default;
};

/// Baked light: illuminance of surfaces, linear RGB, with all that reaches them by whatever way.
struct Lightmap {
    glm::ivec2 size{0};
    std::vector<std::array<std::uint16_t, 4>> luxels;  ///< Half floats in kilolux, rows from v = 0; alpha is 1.
    std::vector<LightmapLayout> layouts;               ///< One for each mesh of the scene.
    std::vector<LightmapPlace> places;                 ///< One for each object of the scene.
    double luxels_per_m = 0.0;                         ///< Reached, after the budget was kept.
    std::uint64_t key = 0;                             ///< Of all that it was made from: lightmap_key().
    bool operator==(const Lightmap&) const = default;
};

/// A point of an object's surface.
struct SurfacePoint {
    ObjectId object = 0;
    std::uint32_t triangle = 0;
    glm::vec3 barycentric{1.0f, 0.0f, 0.0f};
    bool is_back = false;
};

/// A luxel and its share in what is shown.
struct BlendedLuxel {
    std::uint32_t luxel = 0;  ///< Index into Lightmap::luxels.
    float share = 0.0f;
};

/// The luxels that a renderer blends there: four of a chart, or three vertices; none for an object without baked light.
/// The scene's mesh may have its lightmap stream already or not.
std::vector<BlendedLuxel> blended_luxels(const Lightmap& lightmap, const Scene& scene, const SurfacePoint& point);

/// Illuminance that a luxel holds, and that a renderer shows at a point; lux.
glm::vec3 luxel_illuminance(const Lightmap& lightmap, std::uint32_t luxel);
glm::vec3 baked_illuminance(const Lightmap& lightmap, const Scene& scene, const SurfacePoint& point);

/// Appends the copied vertices to all streams of the mesh and fills MeshData::lightmap_uv. Nothing moves and triangles
/// keep their order. No effect for an empty layout or one per vertex. The layout was made for this mesh.
void add_lightmap_stream(MeshData& mesh, const LightmapLayout& layout);

}  // namespace hw
