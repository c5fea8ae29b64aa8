#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "hatchway/geometry/exact/viewpoint.hpp"
#include "hatchway/geometry/surface/surface.hpp"

namespace hw {

/// OpenMesh's half-edge mesh over the repaired faces of a surface, in the order of the model's triangles, and their
/// corners as these come: what a program that loads the model into OpenMesh goes through. (Our surfaces put faces that
/// lie close together side by side.) Every face of the surface is in it; where OpenMesh refuses a face (complex edge or
/// vertex, a surface that cannot be oriented) its corners are duplicated.
class HalfEdgeMesh {
 public:
    explicit HalfEdgeMesh(const Surface& surface);
    ~HalfEdgeMesh();
    HalfEdgeMesh(HalfEdgeMesh&&) noexcept;
    HalfEdgeMesh& operator=(HalfEdgeMesh&&) noexcept;

    std::uint32_t face_count() const;
    std::uint32_t vertex_count() const;
    std::uint32_t edge_count() const;
    std::uint32_t refused_faces() const;  ///< That got corners of their own.

    /// The plain way to find silhouettes, for comparison: over all edges, precomputed float normals, eye to the edge's
    /// middle. Edge numbers are OpenMesh's.
    void plain_silhouettes(const Viewpoint& viewpoint_object, std::vector<int>& edges) const;

    /// The same with the facing of each face kept for its edges: one product a face, eye to its first corner, and two
    /// bytes compared an edge. The fastest of what OpenMesh's users do.
    void kept_facing_silhouettes(const Viewpoint& viewpoint_object, std::vector<int>& edges);

    /// The ends of an edge as positions of the surface.
    std::array<std::uint32_t, 2> edge_ends(int edge) const;

 private:
    struct Mesh;
    std::unique_ptr<Mesh> mesh_;
};

}  // namespace hw
