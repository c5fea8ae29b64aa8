#include "measure/silhouettes/half_edge_mesh.hpp"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <algorithm>
#include <numeric>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

struct Traits : OpenMesh::DefaultTraits {
    FaceAttributes(OpenMesh::Attributes::Normal);
};

using TriMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

TriMesh::Point float_point(const glm::dvec3& p)
{
    return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

std::vector<std::uint32_t> in_model_order(const Surface& surface)
{
    std::vector<std::uint32_t> order(surface.faces.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](auto a, auto b) { return surface.face_triangle[a] < surface.face_triangle[b]; });
    return order;
}

}  // namespace

struct HalfEdgeMesh::Mesh {
    TriMesh tri;
    std::uint32_t refused_faces = 0;
    std::vector<std::uint32_t> original;  // for each vertex its position in the surface
    std::vector<unsigned char> is_front;  // of each face, from the last eye

    TriMesh::VertexHandle add_vertex(const Surface& surface, std::uint32_t position)
    {
        original.push_back(position);
        const glm::vec3& p = surface.positions[position];
        return tri.add_vertex({p.x, p.y, p.z});
    }
};

HalfEdgeMesh::HalfEdgeMesh(const Surface& surface) : mesh_(std::make_unique<Mesh>())
{
    TriMesh& tri = mesh_->tri;
    tri.reserve(surface.positions.size(), surface.faces.size() * 3 / 2, surface.faces.size());
    std::vector<TriMesh::VertexHandle> vertex_at(surface.positions.size());  // invalid: not met yet
    // A refused face is no error here, so OpenMesh's report of it must not reach the user.
    const bool was_enabled = omerr().is_enabled();
    omerr().disable();
    for (const std::uint32_t face : in_model_order(surface)) {
        const FaceCorners& corners = surface.faces[face];
        std::array<TriMesh::VertexHandle, 3> vertices;
        for (std::size_t i = 0; i < 3; ++i) {
            TriMesh::VertexHandle& vertex = vertex_at[corners[i]];
            if (!vertex.is_valid()) vertex = mesh_->add_vertex(surface, corners[i]);
            vertices[i] = vertex;
        }
        if (tri.add_face(vertices[0], vertices[1], vertices[2]).is_valid()) continue;
        ++mesh_->refused_faces;
        for (std::size_t i = 0; i < 3; ++i) vertices[i] = mesh_->add_vertex(surface, corners[i]);
        HW_ASSERT(tri.add_face(vertices[0], vertices[1], vertices[2]).is_valid());
    }
    if (was_enabled) omerr().enable();
    tri.update_face_normals();
}

HalfEdgeMesh::~HalfEdgeMesh() = default;
HalfEdgeMesh::HalfEdgeMesh(HalfEdgeMesh&&) noexcept = default;
HalfEdgeMesh& HalfEdgeMesh::operator=(HalfEdgeMesh&&) noexcept = default;

std::uint32_t HalfEdgeMesh::face_count() const
{
    return static_cast<std::uint32_t>(mesh_->tri.n_faces());
}
std::uint32_t HalfEdgeMesh::vertex_count() const
{
    return static_cast<std::uint32_t>(mesh_->tri.n_vertices());
}
std::uint32_t HalfEdgeMesh::edge_count() const
{
    return static_cast<std::uint32_t>(mesh_->tri.n_edges());
}
std::uint32_t HalfEdgeMesh::refused_faces() const
{
    return mesh_->refused_faces;
}

std::array<std::uint32_t, 2> HalfEdgeMesh::edge_ends(int edge) const
{
    const auto side = mesh_->tri.halfedge_handle(TriMesh::EdgeHandle(edge), 0);
    return {mesh_->original[mesh_->tri.from_vertex_handle(side).idx()],
            mesh_->original[mesh_->tri.to_vertex_handle(side).idx()]};
}

void HalfEdgeMesh::plain_silhouettes(const Viewpoint& viewpoint_object, std::vector<int>& edges) const
{
    edges.clear();
    const TriMesh& tri = mesh_->tri;
    const TriMesh::Point eye = float_point(viewpoint_object.eye);
    for (const auto edge : tri.edges()) {
        const auto side_a = tri.halfedge_handle(edge, 0), side_b = tri.halfedge_handle(edge, 1);
        if (tri.is_boundary(side_a) || tri.is_boundary(side_b)) continue;
        const TriMesh::Point middle =
            (tri.point(tri.to_vertex_handle(side_a)) + tri.point(tri.to_vertex_handle(side_b))) * 0.5f;
        const TriMesh::Point to_viewer = viewpoint_object.is_orthographic ? eye : eye - middle;
        const bool a = dot(tri.normal(tri.face_handle(side_a)), to_viewer) > 0.0f;
        const bool b = dot(tri.normal(tri.face_handle(side_b)), to_viewer) > 0.0f;
        if (a != b) edges.push_back(edge.idx());
    }
}

void HalfEdgeMesh::kept_facing_silhouettes(const Viewpoint& viewpoint_object, std::vector<int>& edges)
{
    edges.clear();
    const TriMesh& tri = mesh_->tri;
    const TriMesh::Point eye = float_point(viewpoint_object.eye);
    mesh_->is_front.resize(tri.n_faces());
    for (const auto face : tri.faces()) {
        const TriMesh::Point& corner = tri.point(tri.to_vertex_handle(tri.halfedge_handle(face)));
        const TriMesh::Point to_viewer = viewpoint_object.is_orthographic ? eye : eye - corner;
        mesh_->is_front[static_cast<std::size_t>(face.idx())] = dot(tri.normal(face), to_viewer) > 0.0f;
    }
    for (const auto edge : tri.edges()) {
        const int a = tri.face_handle(tri.halfedge_handle(edge, 0)).idx();
        const int b = tri.face_handle(tri.halfedge_handle(edge, 1)).idx();
        if (a < 0 || b < 0) continue;
        if (mesh_->is_front[static_cast<std::size_t>(a)] != mesh_->is_front[static_cast<std::size_t>(b)])
            edges.push_back(edge.idx());
    }
}

}  // namespace hw
