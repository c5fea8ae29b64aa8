#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "hatchway/io/meshes/checked_mesh.hpp"

namespace hw {

enum class MeshFormat : unsigned char { obj, ply, stl, off };

/// A mesh as OpenMesh's reader tells it: polygons, in the file's order, none left out.
struct RawMesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;         ///< Of vertices; empty, or as long as the positions. So are the next two.
    std::vector<glm::vec2> uv;              ///< v upwards.
    std::vector<glm::vec4> colours;         ///< sRGB.
    std::vector<std::uint32_t> corners;     ///< Vertices of the faces, one face after the other.
    std::vector<std::uint32_t> face_ends;   ///< Where each face's corners end.
    std::vector<glm::vec3> corner_normals;  ///< Empty, or as long as the corners; zero where a face has none.
    std::vector<glm::vec2> corner_uv;       ///< Likewise.
    std::vector<glm::vec4> face_colours;    ///< sRGB; empty, or one for each face.
};

/// Has OpenMesh read a checked file. Throws hw::Error when it gives other numbers of vertices or faces than the check.
RawMesh read_raw_mesh(MeshFormat format, CheckedMesh& mesh, const std::string& name);

}  // namespace hw
