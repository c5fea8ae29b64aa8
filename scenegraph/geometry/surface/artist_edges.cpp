#include "hatchway/geometry/surface/artist_edges.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace hw {
namespace {

constexpr float kSplitCosine = 0.9994f;     // normals 2 degrees apart: more than the noise of exporters
constexpr float kStatisticFoldRad = 1.05f;  // folds above are sharp in any shading and say nothing about it
constexpr double kFlatShadedShare = 0.95;

class NormalSplits {
 public:
    NormalSplits(const Surface& surface, const MeshData& mesh, std::span<const std::uint32_t> position_of_vertex)
        : surface_(surface), mesh_(mesh), position_of_vertex_(position_of_vertex)
    {
    }

    /// Whether the two faces state different normals at both ends of their edge.
    bool is_split(const InnerEdge& edge) const
    {
        return are_apart(edge, edge.vertices[0]) && are_apart(edge, edge.vertices[1]);
    }

 private:
    glm::vec3 stated_normal(std::uint32_t face, std::uint32_t position) const
    {
        if (surface_.face_triangle[face] == kNoFace) return glm::vec3(0.0f);
        const std::uint32_t* corner = &mesh_.indices[3 * std::size_t{surface_.face_triangle[face]}];
        for (int i = 0; i < 3; ++i) {
            if (position_of_vertex_[corner[i]] == position) return mesh_.normals[corner[i]];
        }
        return glm::vec3(0.0f);
    }
    bool are_apart(const InnerEdge& edge, std::uint32_t position) const
    {
        const glm::vec3 a = stated_normal(edge.edge.face_a(), position), b = stated_normal(edge.edge.face_b, position);
        if (a == glm::vec3(0.0f) || b == glm::vec3(0.0f)) return false;
        // Of a sheet that is modelled from both sides one of two normals is left, that of either side.
        const bool is_either = surface_.is_two_sided(edge.edge.face_a()) || surface_.is_two_sided(edge.edge.face_b);
        return (is_either ? std::abs(glm::dot(a, b)) : glm::dot(a, b)) < kSplitCosine;
    }

    const Surface& surface_;
    const MeshData& mesh_;
    std::span<const std::uint32_t> position_of_vertex_;
};

/// Whether two vertices of the mesh have one position; else no normals can differ across an edge.
bool are_vertices_split(const MeshData& mesh, std::span<const std::uint32_t> position_of_vertex,
                        std::size_t position_count)
{
    std::vector<std::uint32_t> vertex_at(position_count, kNoFace);
    return std::any_of(mesh.indices.begin(), mesh.indices.end(), [&](std::uint32_t vertex) {
        std::uint32_t& first = vertex_at[position_of_vertex[vertex]];
        if (first == kNoFace) first = vertex;
        return first != vertex;
    });
}

struct Shading {
    std::uint32_t folded = 0;
    std::uint32_t split = 0;
    bool is_flat() const { return split >= kFlatShadedShare * folded; }
};

void mark_split_normals(std::vector<InnerEdge>& edges, const Surface& surface, const NormalSplits& splits,
                        float least_fold_rad)
{
    std::vector<Shading> shading(surface.components.size());
    std::vector<bool> is_split(edges.size(), false);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const InnerEdge& edge = edges[i];
        if (edge.edge.face_b >= surface.faces.size() || edge.fold_rad <= least_fold_rad) continue;
        is_split[i] = splits.is_split(edge);
        if (edge.fold_rad > kStatisticFoldRad) continue;
        Shading& component = shading[surface.face_component[edge.edge.face_a()]];
        ++component.folded;
        component.split += is_split[i];
    }
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (is_split[i] && !shading[surface.face_component[edges[i].edge.face_a()]].is_flat())
            edges[i].is_artist = true;
    }
}

std::uint64_t edge_key(std::uint32_t a, std::uint32_t b)
{
    return static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
}

void mark_named_edges(std::vector<InnerEdge>& edges, const MeshData& mesh,
                      std::span<const std::uint32_t> position_of_vertex)
{
    std::vector<std::uint64_t> named;
    for (std::size_t i = 0; i + 1 < mesh.artist_edges.size(); i += 2) {
        named.push_back(
            edge_key(position_of_vertex[mesh.artist_edges[i]], position_of_vertex[mesh.artist_edges[i + 1]]));
    }
    std::sort(named.begin(), named.end());
    for (InnerEdge& edge : edges) {
        if (std::binary_search(named.begin(), named.end(), edge_key(edge.vertices[0], edge.vertices[1]))) {
            edge.is_artist = true;
        }
    }
}

}  // namespace

void mark_artist_edges(std::vector<InnerEdge>& edges, const Surface& surface, const MeshData& mesh,
                       std::span<const std::uint32_t> position_of_vertex, float least_fold_rad)
{
    if (mesh.has_own_normals && !mesh.normals.empty() &&
        are_vertices_split(mesh, position_of_vertex, surface.positions.size())) {
        mark_split_normals(edges, surface, NormalSplits(surface, mesh, position_of_vertex), least_fold_rad);
    }
    if (!mesh.artist_edges.empty()) mark_named_edges(edges, mesh, position_of_vertex);
}

}  // namespace hw
