#include "hatchway/geometry/surface/surface.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

#include "hatchway/core/radix_sort.hpp"
#include "hatchway/geometry/surface/angle_change.hpp"
#include "hatchway/geometry/surface/artist_edges.hpp"
#include "hatchway/geometry/surface/inherited_planes.hpp"
#include "hatchway/geometry/surface/outline_order.hpp"
#include "hatchway/geometry/surface/surface_faces.hpp"
#include "hatchway/geometry/topology/meant_winding.hpp"
#include "hatchway/geometry/topology/repaired_mesh.hpp"

namespace hw {
namespace {

class SurfaceBuild {
 public:
    SurfaceBuild(const MeshData& mesh, const SurfaceOptions& options) : mesh_(mesh), options_(options) {}

    Surface run()
    {
        weld_and_repair();
        if (inherit_planes(surface_)) uses_ = sorted_directed_edges(surface_.faces);
        judge_components();
        collect_edges();
        mark_artist_edges(inner_, surface_, mesh_, position_of_vertex_, options_.artist_fold_rad);
        fill_table();
        surface_.filter.prepare(surface_.positions, surface_.faces);
        if (surface_.faces.size() >= options_.cluster_from_faces) surface_.clusters.prepare(surface_);
        return std::move(surface_);
    }

 private:
    void weld_and_repair()
    {
        WeldedMesh welded = weld(mesh_);
        SurfaceReport& report = surface_.report;
        report.triangles_in = static_cast<std::uint32_t>(mesh_.triangle_count());
        report.removed_faces = report.triangles_in - static_cast<std::uint32_t>(welded.faces.size());
        RepairedMesh repaired = repair_mesh(in_outline_order(std::move(welded)), options_.stitch_share);
        keep_meant_winding(mesh_, repaired);
        surface_.positions = std::move(repaired.positions);
        surface_.faces = std::move(repaired.faces);
        surface_.face_triangle = std::move(repaired.face_triangle);
        surface_.two_sided_faces = std::move(repaired.two_sided_faces);
        surface_.face_component = std::move(repaired.face_component);
        surface_.components.resize(repaired.component_count);
        report.doubled_faces = static_cast<std::uint32_t>(repaired.doubled_triangles.size());
        report.stitched_edges = repaired.stitched_edges;
        report.pinholes = repaired.pinholes;
        report.t_junction_edges = repaired.t_junction_edges;
        report.flipped_faces = static_cast<std::uint32_t>(repaired.flipped_faces.size());
        position_of_vertex_ = std::move(repaired.vertex_position);
        uses_ = std::move(repaired.uses);
        surface_.normal_from_object = fold_normal_matrix(options_.world_from_object);
    }

    /// Positions again in the order of first use, so that what is near in one list is near in the other.
    static WeldedMesh in_outline_order(const WeldedMesh& welded)
    {
        WeldedMesh ordered;
        ordered.positions.reserve(welded.positions.size());
        ordered.faces.reserve(welded.faces.size());
        ordered.face_triangle.reserve(welded.faces.size());
        std::vector<std::uint32_t> new_id(welded.positions.size(), kNoFace);
        const auto id_of = [&](std::uint32_t position) {
            if (new_id[position] == kNoFace) {
                new_id[position] = static_cast<std::uint32_t>(ordered.positions.size());
                ordered.positions.push_back(welded.positions[position]);
            }
            return new_id[position];
        };
        for (const std::uint32_t face : outline_order(welded.positions, welded.faces)) {
            const auto& [a, b, c] = welded.faces[face];
            ordered.faces.push_back({id_of(a), id_of(b), id_of(c)});
            ordered.face_triangle.push_back(welded.face_triangle[face]);
        }
        for (const std::uint32_t position : welded.vertex_position)
            ordered.vertex_position.push_back(welded.positions.empty() ? 0 : id_of(position));
        return ordered;
    }

    void judge_components()
    {
        for (SurfaceComponent& component : surface_.components) component.is_closed = true;
        for (std::uint32_t face = 0; face < surface_.two_sided_faces.size(); ++face)
            if (surface_.two_sided_faces[face]) component_of(face).is_two_sided = true;
        for_each_edge(uses_, [&](std::span<const DirectedEdge> edge) {
            if (edge.size() == 2 && edge[0].is_forward != edge[1].is_forward) return;
            for (const DirectedEdge& use : edge) component_of(use.face).is_closed = false;
        });
        const std::vector<double> volumes = signed_volumes();
        SurfaceReport& report = surface_.report;
        report.components = static_cast<std::uint32_t>(surface_.components.size());
        for (std::size_t i = 0; i < surface_.components.size(); ++i) {
            SurfaceComponent& component = surface_.components[i];
            component.is_outward = component.is_closed && volumes[i] > 0.0;
            component.has_reflex_rule = component.is_outward && options_.is_solid && !component.is_two_sided;
            report.closed_components += component.is_closed;
            report.inward_components += component.is_closed && !component.is_two_sided && volumes[i] < 0.0;
            report.reflex_rule_components += component.has_reflex_rule;
        }
    }

    SurfaceComponent& component_of(std::uint32_t face) { return surface_.components[surface_.face_component[face]]; }

    std::vector<double> signed_volumes()
    {
        std::vector<double> volumes(surface_.components.size(), 0.0);
        std::vector<std::uint32_t> origin(surface_.components.size(), kNoFace);
        for (std::uint32_t face = 0; face < surface_.faces.size(); ++face) {
            const auto& corners = surface_.faces[face];
            const std::uint32_t id = surface_.face_component[face];
            ++surface_.components[id].face_count;
            if (origin[id] == kNoFace) origin[id] = corners[0];
            const glm::dvec3 o = surface_.positions[origin[id]];
            const glm::dvec3 a = glm::dvec3(surface_.positions[corners[0]]) - o,
                             b = glm::dvec3(surface_.positions[corners[1]]) - o,
                             c = glm::dvec3(surface_.positions[corners[2]]) - o;
            volumes[id] += glm::dot(glm::cross(a, b), c);
        }
        return volumes;
    }

    void collect_edges()
    {
        SurfaceReport& report = surface_.report;
        inner_.reserve(uses_.size() / 2);
        for_each_edge(uses_, [&](std::span<const DirectedEdge> uses) {
            const DirectedEdge& use = uses[0];
            Edge edge{Edge::side(use.face, use.corner), uses.size() == 1 ? kNoFace : uses[1].face};
            if (uses.size() != 2) {
                ++(uses.size() == 1 ? report.border_edges : report.complex_edges);
                for (std::size_t i = 2; i < uses.size(); ++i)
                    surface_.edges.more_faces.push_back({surface_.edges.size(), uses[i].face});
                surface_.edges.edges.push_back(edge);
                return;
            }
            if (use.is_forward == uses[1].is_forward) {
                surface_.filter.twins.push_back({edge.face_b});
                edge.face_b = static_cast<std::uint32_t>(surface_.faces.size() + surface_.filter.twins.size() - 1);
            }
            inner_.push_back({.edge = edge, .vertices = {use.low, use.high}});
        });
        report.inconsistent_edges = static_cast<std::uint32_t>(surface_.filter.twins.size());
        measure_folds();
    }

    void measure_folds()
    {
        std::vector<glm::dvec3> normals(surface_.faces.size() + surface_.filter.twins.size());
        for (std::uint32_t face = 0; face < normals.size(); ++face) normals[face] = plane_normal(surface_, face);
        for (InnerEdge& inner : inner_)
            inner.fold_rad = angle_between(normals[inner.edge.face_a()], normals[inner.edge.face_b]);
    }

    EdgeGroup group_of(const InnerEdge& edge) const
    {
        const int sign = convexity_sign(surface_, edge.edge.face_a(), edge.edge.face_b);
        // Two faces folded onto each other are coplanar, yet a knife's edge and not flat.
        const bool is_convex = sign < 0 || (sign == 0 && edge.fold_rad > 1.0f);
        if (edge.is_artist) return is_convex ? EdgeGroup::artist_convex : EdgeGroup::artist_reflex;
        if (is_convex) return EdgeGroup::convex;
        const SurfaceComponent& component = surface_.components[surface_.face_component[edge.edge.face_a()]];
        return sign == 0 || component.has_reflex_rule ? EdgeGroup::reflex_silent : EdgeGroup::reflex;
    }

    void fill_table()
    {
        EdgeTable& table = surface_.edges;
        std::array<std::vector<KeyedIndex>, kEdgeGroupCount> groups;
        for (std::uint32_t i = 0; i < inner_.size(); ++i) {
            // The bits of floats from 0 on rise with them.
            const std::uint32_t falling = ~std::bit_cast<std::uint32_t>(inner_[i].fold_rad);
            groups[static_cast<std::size_t>(group_of(inner_[i]))].push_back({falling, i});
            surface_.report.artist_edges += inner_[i].is_artist;
        }
        table.edges.reserve(table.size() + inner_.size());
        for (std::size_t group = 1; group < groups.size(); ++group) {  // borders stand in the first
            table.group_begin[group] = table.size();
            radix_sort(groups[group]);
            for (const KeyedIndex& edge : groups[group]) table.edges.push_back(inner_[edge.index].edge);
        }
        table.group_begin[kEdgeGroupCount] = table.size();
    }

    const MeshData& mesh_;
    const SurfaceOptions& options_;
    Surface surface_;
    std::vector<std::uint32_t> position_of_vertex_;
    std::vector<DirectedEdge> uses_;
    std::vector<InnerEdge> inner_;
};

}  // namespace

Surface build_surface(const MeshData& mesh, const SurfaceOptions& options)
{
    return SurfaceBuild(mesh, options).run();
}

OutlineBytes outline_bytes(const Surface& surface)
{
    return {.edges = surface.edges.edges.size() * sizeof(Edge) + surface.edges.more_faces.size() * sizeof(MoreFace),
            .planes = surface.filter.bytes(),
            .clusters = surface.clusters.bytes()};
}

}  // namespace hw
