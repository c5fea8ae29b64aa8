#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "hatchway/io/meshes/text.hpp"

namespace hw {

/// Corners of one polygon.
inline constexpr std::uint64_t kMaxPolygonCorners = 4096;

/// What becomes an object: a group of a file, in one material. All names may be empty.
struct MeshPart {
    std::string object;  ///< OBJ "o"; STL "solid".
    std::string group;   ///< OBJ "g".
    std::string material;
};

/// From this face on, faces belong to that part, until the next run.
struct PartRun {
    std::uint64_t first_face = 0;
    std::size_t part = 0;
};

/// A file that was checked, as the text that OpenMesh's reader of its format reads without a loss: what that reader
/// would misread is taken out, and kept here where it can be used. Every number in the text is finite, every index in
/// range, every count true.
struct CheckedMesh {
    std::string text;
    bool is_binary = false;
    std::uint64_t vertices = 0;
    std::uint64_t faces = 0;  ///< Of three corners at least.
    bool has_normals = false;
    bool has_colours = false;
    bool has_uv = false;
    bool has_face_colours = false;
    std::vector<glm::vec3> normals;       ///< Of vertices, where OpenMesh does not tell them (OFF).
    std::vector<glm::vec4> colours;       ///< Likewise, sRGB.
    std::vector<glm::vec4> face_colours;  ///< Likewise.
    std::vector<MeshPart> parts{1};
    std::vector<PartRun> runs{{}};
    std::vector<std::string> material_files;  ///< As the file names them, each once.
    std::uint64_t faces_without_area = 0;     ///< Left out: fewer than three different corners.
    std::uint64_t lines_and_points = 0;       ///< Left out: what is no face.
};

/// Refuse more vertices or triangles than a scene may have.
void check_vertex_count(std::uint64_t count, const FilePlace& place);
void check_triangle_count(std::uint64_t count, const FilePlace& place);

/// Refuses a polygon of over kMaxPolygonCorners.
void check_corner_count(std::int64_t count, const FilePlace& place);

/// The float nearest to a coordinate. Refuses one that is not finite or over limits::kMaxCoordinate.
float checked_coordinate(double value, const FilePlace& place);

}  // namespace hw
