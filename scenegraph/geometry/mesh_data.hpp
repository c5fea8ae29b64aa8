#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace hw {

/// A triangle mesh as the model states it, object space, metres. Streams are empty or as long as `positions`.
/// Everything is finite and every index is in range: whoever makes one has checked that.
struct MeshData {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;   ///< Unit, or zero where the model states none that can be used.
    std::vector<glm::vec4> tangents;  ///< xyz unit, w = +1 or -1: bitangent = w * cross(normal, tangent).
    std::vector<glm::vec2> uv0;
    std::vector<glm::vec2> uv1;
    std::vector<glm::vec2> lightmap_uv;       ///< In luxels of the mesh; only where light has been baked.
    std::vector<glm::vec4> colours;           ///< Linear RGBA.
    std::vector<std::uint32_t> indices;       ///< Three per triangle, counter-clockwise seen from outside.
    bool has_own_normals = false;             ///< The model stated normals; false: made by the importer (flat).
    std::vector<std::uint32_t> artist_edges;  ///< Pairs of vertex indices that the artist marked to be drawn.

    std::size_t triangle_count() const { return indices.size() / 3; }
};

}  // namespace hw
