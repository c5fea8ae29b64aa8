#include "hatchway/io/meshes/mesh_build.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <unordered_map>

#include "hatchway/core/hash.hpp"
#include "hatchway/core/srgb.hpp"
#include "hatchway/geometry/surface/crease_normals.hpp"
#include "hatchway/geometry/surface/triangulation.hpp"
#include "hatchway/geometry/unit_normal.hpp"

namespace hw {
namespace {

constexpr float kCreaseDeg = 40.0f;  // as ink draws creases unless it is told otherwise
constexpr std::uint32_t kUnused = 0xffffffffu;

glm::vec4 linear_from_srgb(const glm::vec4& c)
{
    return {hw::linear_from_srgb(c.r), hw::linear_from_srgb(c.g), hw::linear_from_srgb(c.b), c.a};
}

/// Colours as numbers to 255 when one is over 1, as some programs write them.
std::vector<glm::vec4> in_unit_range(std::vector<glm::vec4> colours)
{
    const bool is_bytes = std::ranges::any_of(colours, [](const glm::vec4& c) {
        return std::max({c.r, c.g, c.b}) > 1.0f;
    });
    const float scale = is_bytes ? 1.0f / 255.0f : 1.0f;
    for (glm::vec4& c : colours) c = glm::clamp(glm::vec4(scale * glm::vec3(c), c.a), 0.0f, 1.0f);
    return colours;
}

/// What one corner of a triangle is.
struct Corner {
    std::uint32_t number;  ///< Into RawMesh::corners.
    std::uint32_t face;
};

/// The attributes in which the corners of one vertex may differ.
struct CornerKey {
    std::uint32_t vertex;
    glm::vec3 normal{0.0f};
    glm::vec2 uv{0.0f};
    glm::vec4 colour{1.0f};
    bool operator==(const CornerKey&) const = default;
};
struct CornerKeyHash {
    std::size_t operator()(const CornerKey& key) const { return hash_bytes(std::as_bytes(std::span(&key, 1))); }
};

/// Makes the mesh of one part after the other.
class PartBuilder {
 public:
    explicit PartBuilder(const RawMesh& raw, std::vector<glm::vec4> colours)
        : raw_(raw),
          colours_(std::move(colours)),
          has_face_colours_(colours_.empty() && !raw.face_colours.empty()),
          has_corner_attributes_(has_face_colours_ || !raw.corner_normals.empty() || !raw.corner_uv.empty()),
          vertex_of_(has_corner_attributes_ ? 0 : raw.positions.size(), kUnused)
    {
    }

    MeshData build(std::span<const Corner> corners)
    {
        MeshData mesh;
        mesh.indices.reserve(corners.size());
        for (const Corner& corner : corners) mesh.indices.push_back(vertex_of(corner, mesh));
        for (const Corner& corner : corners)
            if (!has_corner_attributes_) vertex_of_[raw_.corners[corner.number]] = kUnused;
        copies_.clear();
        if (std::ranges::find(mesh.normals, glm::vec3(0.0f)) != mesh.normals.end()) mesh.normals.clear();
        mesh.has_own_normals = !mesh.normals.empty();
        if (!mesh.has_own_normals) add_crease_normals(mesh, glm::radians(kCreaseDeg));
        return mesh;
    }

 private:
    std::uint32_t vertex_of(const Corner& corner, MeshData& mesh)
    {
        const std::uint32_t vertex = raw_.corners[corner.number];
        const auto next = static_cast<std::uint32_t>(mesh.positions.size());
        if (!has_corner_attributes_) {
            if (vertex_of_[vertex] == kUnused) {
                vertex_of_[vertex] = next;
                append(corner, mesh);
            }
            return vertex_of_[vertex];
        }
        CornerKey key{.vertex = vertex};
        if (!raw_.corner_normals.empty()) key.normal = raw_.corner_normals[corner.number];
        if (!raw_.corner_uv.empty()) key.uv = raw_.corner_uv[corner.number];
        if (has_face_colours_) key.colour = raw_.face_colours[corner.face];
        const auto [found, is_new] = copies_.try_emplace(key, next);
        if (is_new) append(corner, mesh);
        return found->second;
    }

    void append(const Corner& corner, MeshData& mesh) const
    {
        const std::uint32_t vertex = raw_.corners[corner.number];
        mesh.positions.push_back(raw_.positions[vertex]);
        if (!raw_.corner_normals.empty())
            mesh.normals.push_back(unit_or_zero(raw_.corner_normals[corner.number]));
        else if (!raw_.normals.empty())
            mesh.normals.push_back(unit_or_zero(raw_.normals[vertex]));
        const bool has_corner_uv = !raw_.corner_uv.empty();
        if (has_corner_uv || !raw_.uv.empty()) {
            const glm::vec2 uv = has_corner_uv ? raw_.corner_uv[corner.number] : raw_.uv[vertex];
            mesh.uv0.emplace_back(uv.x, 1.0f - uv.y);
        }
        if (!colours_.empty())
            mesh.colours.push_back(linear_from_srgb(colours_[vertex]));
        else if (has_face_colours_)
            mesh.colours.push_back(linear_from_srgb(raw_.face_colours[corner.face]));
    }

    const RawMesh& raw_;
    std::vector<glm::vec4> colours_;
    bool has_face_colours_;
    bool has_corner_attributes_;
    std::vector<std::uint32_t> vertex_of_;  ///< Of the file's vertices in the mesh at hand.
    std::unordered_map<CornerKey, std::uint32_t, CornerKeyHash> copies_;
};

/// The corners of all triangles, by part.
std::vector<std::vector<Corner>> triangle_corners(const RawMesh& raw, const CheckedMesh& checked)
{
    std::vector<std::vector<Corner>> parts(checked.parts.size());
    if (parts.size() == 1) parts[0].reserve(3 * raw.face_ends.size());
    std::vector<glm::vec3> polygon;
    std::vector<std::uint32_t> triangles;
    std::size_t run = 0;
    std::uint32_t begin = 0;
    for (std::uint32_t face = 0; face < raw.face_ends.size(); ++face) {
        while (run + 1 < checked.runs.size() && checked.runs[run + 1].first_face <= face) ++run;
        polygon.clear();
        triangles.clear();
        for (std::uint32_t i = begin; i < raw.face_ends[face]; ++i) polygon.push_back(raw.positions[raw.corners[i]]);
        triangulate(polygon, triangles);
        for (const std::uint32_t corner : triangles)
            parts[checked.runs[run].part].push_back({.number = begin + corner, .face = face});
        begin = raw.face_ends[face];
    }
    return parts;
}

}  // namespace

std::vector<MeshData> build_meshes(const RawMesh& raw, const CheckedMesh& checked)
{
    PartBuilder builder(raw, in_unit_range(raw.colours));
    std::vector<MeshData> meshes;
    for (std::vector<Corner>& corners : triangle_corners(raw, checked)) {
        meshes.push_back(builder.build(corners));
        corners = {};
    }
    return meshes;
}

}  // namespace hw
