#include "hatchway/geometry/topology/repaired_mesh.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "hatchway/geometry/topology/doubled_faces.hpp"
#include "hatchway/geometry/topology/doubled_patches.hpp"
#include "hatchway/geometry/topology/near_doubles.hpp"
#include "hatchway/geometry/topology/orientation.hpp"
#include "hatchway/geometry/topology/pinholes.hpp"
#include "hatchway/geometry/topology/stitch.hpp"
#include "hatchway/geometry/topology/t_junctions.hpp"

namespace hw {
namespace {

class MeshRepair {
 public:
    MeshRepair(WeldedMesh mesh, float stitch_share) : stitch_share_(stitch_share)
    {
        made_.positions = std::move(mesh.positions);
        made_.vertex_position = std::move(mesh.vertex_position);
        made_.faces = std::move(mesh.faces);
        made_.face_triangle = std::move(mesh.face_triangle);
        tolerance_ = stitch_share * diagonal();
    }

    RepairedMesh run()
    {
        made_.uses = sorted_directed_edges(made_.faces);
        join_doubled();
        if (has_borders()) {
            join_near();
            stitch();
            close_holes();
            close();
        }
        wind();
        return std::move(made_);
    }

 private:
    float diagonal() const
    {
        if (made_.positions.empty()) return 0.0f;
        glm::vec3 low = made_.positions[0], high = low;
        for (const glm::vec3& p : made_.positions) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        return static_cast<float>(glm::distance(glm::dvec3(low), glm::dvec3(high)));
    }

    bool has_borders() const
    {
        bool result = false;
        for_each_edge(made_.uses, [&](std::span<const DirectedEdge> edge) { result |= edge.size() == 1; });
        return result;
    }

    void join_doubled()
    {
        leave_out(find_doubled_faces(made_.faces, made_.uses, made_.face_triangle));
        leave_out(find_doubled_patches(made_.positions, made_.faces, made_.uses, made_.face_triangle, tolerance_));
    }

    void leave_out(const DoubledFaces& doubled)
    {
        if (doubled.is_dropped.empty()) return;
        const std::size_t count = made_.faces.size();
        made_.two_sided_faces.resize(count, false);
        for (std::size_t face = 0; face < count; ++face) {
            if (doubled.is_dropped[face]) made_.doubled_triangles.push_back(made_.face_triangle[face]);
            if (doubled.is_two_sided[face]) made_.two_sided_faces[face] = true;
        }
        const std::vector<std::uint32_t> new_number =
            keep_faces([&](std::size_t face) { return !doubled.is_dropped[face]; });
        for (DirectedEdge& use : made_.uses) use.face = new_number[use.face];
        std::erase_if(made_.uses, [](const DirectedEdge& use) { return use.face == kNoFace; });
    }

    void join_near()
    {
        const std::vector<FaceCorners> before = made_.faces;
        if (!join_near_doubles(made_.positions, made_.faces, made_.uses, made_.face_triangle, tolerance_)) return;
        drop_unused_positions(before);
        made_.uses = sorted_directed_edges(made_.faces);
        join_doubled();
    }

    void stitch()
    {
        const std::vector<FaceCorners> before = made_.faces;
        made_.stitched_edges = stitch_borders(made_.positions, made_.faces, made_.uses, tolerance_);
        if (made_.stitched_edges == 0) return;
        drop_unused_positions(before);
        made_.uses = sorted_directed_edges(made_.faces);
    }

    void close_holes()
    {
        const std::vector<FaceCorners> before = made_.faces;
        made_.pinholes = close_pinholes(made_.positions, made_.faces, made_.uses, stitch_share_);
        if (made_.pinholes == 0) return;
        drop_unused_positions(before);
        keep_faces([&](std::size_t face) {
            const auto& [a, b, c] = made_.faces[face];
            return a != b && b != c && c != a;
        });
        made_.uses = sorted_directed_edges(made_.faces);
    }

    /// Returns the new number of each face, or kNoFace; the order stays.
    template <typename IsKept>
    std::vector<std::uint32_t> keep_faces(const IsKept& is_kept)
    {
        std::size_t kept = 0;
        std::vector<std::uint32_t> new_number(made_.faces.size(), kNoFace);
        for (std::size_t face = 0; face < made_.faces.size(); ++face) {
            if (!is_kept(face)) continue;
            new_number[face] = static_cast<std::uint32_t>(kept);
            made_.faces[kept] = made_.faces[face];
            made_.face_triangle[kept] = made_.face_triangle[face];
            if (!made_.two_sided_faces.empty()) made_.two_sided_faces[kept] = made_.two_sided_faces[face];
            ++kept;
        }
        made_.faces.resize(kept);
        made_.face_triangle.resize(kept);
        if (!made_.two_sided_faces.empty()) made_.two_sided_faces.resize(kept);
        return new_number;
    }

    void drop_unused_positions(const std::vector<FaceCorners>& before)
    {
        std::vector<std::uint32_t> new_id(made_.positions.size(), kNoFace);
        std::vector<glm::vec3> kept;
        std::vector<std::uint32_t> stitched_to(made_.positions.size());
        for (std::size_t face = 0; face < before.size(); ++face) {
            for (int corner = 0; corner < 3; ++corner) {
                const std::uint32_t id = made_.faces[face][corner];
                if (new_id[id] == kNoFace) {
                    new_id[id] = static_cast<std::uint32_t>(kept.size());
                    kept.push_back(made_.positions[id]);
                }
                stitched_to[before[face][corner]] = made_.faces[face][corner] = new_id[id];
            }
        }
        for (std::uint32_t& position : made_.vertex_position) position = stitched_to[position];
        made_.positions = std::move(kept);
    }

    void close()
    {
        made_.t_junction_edges =
            close_t_junctions(made_.positions, made_.faces, made_.uses, made_.two_sided_faces, tolerance_);
        if (made_.t_junction_edges == 0) return;
        made_.face_triangle.resize(made_.faces.size(), kNoFace);
        if (!made_.two_sided_faces.empty()) made_.two_sided_faces.resize(made_.faces.size(), false);
        made_.uses = sorted_directed_edges(made_.faces);
    }

    void wind()
    {
        WindingRepair repair = repair_winding(made_.positions, made_.faces, made_.uses);
        made_.face_component = std::move(repair.face_component);
        made_.component_count = repair.component_count;
        if (repair.flipped_faces.empty()) return;
        made_.uses = sorted_directed_edges(made_.faces);
        made_.flipped_faces = std::move(repair.flipped_faces);
        std::erase_if(made_.flipped_faces, [&](std::uint32_t face) {
            const bool is_two_sided = !made_.two_sided_faces.empty() && made_.two_sided_faces[face];
            return is_two_sided || made_.face_triangle[face] == kNoFace;
        });
    }

    RepairedMesh made_;
    float stitch_share_;
    float tolerance_ = 0.0f;
};

}  // namespace

RepairedMesh repair_mesh(WeldedMesh mesh, float stitch_share)
{
    return MeshRepair(std::move(mesh), stitch_share).run();
}

}  // namespace hw
