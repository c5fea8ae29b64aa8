#include "hatchway/geometry/surface/crease_normals.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <span>

namespace hw {
namespace {

/// The faces at each vertex, as corners 3 f + c.
struct CornersOfVertices {
    std::vector<std::uint32_t> first;  ///< Of each vertex, and one more.
    std::vector<std::uint32_t> corners;

    explicit CornersOfVertices(const MeshData& mesh) : first(mesh.positions.size() + 1), corners(mesh.indices.size())
    {
        for (const std::uint32_t vertex : mesh.indices) ++first[vertex + 1];
        for (std::size_t v = 0; v + 1 < first.size(); ++v) first[v + 1] += first[v];
        std::vector<std::uint32_t> next = first;
        for (std::uint32_t i = 0; i < corners.size(); ++i) corners[next[mesh.indices[i]]++] = i;
    }
    std::span<const std::uint32_t> at(std::size_t vertex) const
    {
        return std::span(corners).subspan(first[vertex], first[vertex + 1] - first[vertex]);
    }
};

class NormalMaker {
 public:
    NormalMaker(MeshData& mesh, float crease_rad) : mesh_(mesh), least_cosine_(std::cos(crease_rad))
    {
        units_.reserve(mesh.triangle_count());
        areas_.reserve(mesh.triangle_count());
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            // In double: edges of 1e-20 m have no cross product in float.
            const glm::dvec3 a(mesh.positions[mesh.indices[i]]);
            const glm::dvec3 cross = glm::cross(glm::dvec3(mesh.positions[mesh.indices[i + 1]]) - a,
                                                glm::dvec3(mesh.positions[mesh.indices[i + 2]]) - a);
            const double length = glm::length(cross);
            units_.push_back(length > 0.0 ? glm::vec3(cross / length) : glm::vec3(0.0f));
            areas_.push_back(length);
        }
    }

    void make()
    {
        const CornersOfVertices faces(mesh_);
        const std::size_t count = mesh_.positions.size();
        mesh_.normals.assign(count, glm::vec3(0.0f));
        for (std::size_t vertex = 0; vertex < count; ++vertex) {
            const std::span<const std::uint32_t> corners = faces.at(vertex);
            const glm::vec3 mean = mean_normal(corners);
            mesh_.normals[vertex] = mean;
            if (!is_within(mean, corners)) part(vertex, corners);
        }
    }

 private:
    const glm::vec3& unit(std::uint32_t corner) const { return units_[corner / 3]; }
    bool has_plane(std::uint32_t corner) const { return areas_[corner / 3] > 0.0; }

    glm::vec3 mean_normal(std::span<const std::uint32_t> corners) const
    {
        glm::dvec3 sum(0.0);
        for (const std::uint32_t corner : corners) sum += glm::dvec3(unit(corner)) * areas_[corner / 3];
        const double length = glm::length(sum);
        return length > 0.0 ? glm::vec3(sum / length) : glm::vec3(0.0f);
    }

    bool is_within(const glm::vec3& mean, std::span<const std::uint32_t> corners) const
    {
        for (const std::uint32_t corner : corners)
            if (has_plane(corner) && glm::dot(mean, unit(corner)) < least_cosine_) return false;
        return true;
    }

    void part(std::size_t vertex, std::span<const std::uint32_t> corners)
    {
        std::vector<std::uint32_t> left;
        for (const std::uint32_t corner : corners)
            if (has_plane(corner)) left.push_back(corner);
        std::vector<std::uint32_t> group;
        for (std::size_t target = vertex; !left.empty(); target = mesh_.positions.size()) {
            const std::uint32_t first = left[0];
            group.clear();
            std::erase_if(left, [&](std::uint32_t corner) {
                const bool is_member = corner == first || glm::dot(unit(first), unit(corner)) >= least_cosine_;
                if (is_member) group.push_back(corner);
                return is_member;
            });
            if (target != vertex) copy_vertex(vertex);
            mesh_.normals[target] = mean_normal(group);
            for (const std::uint32_t corner : group) mesh_.indices[corner] = static_cast<std::uint32_t>(target);
        }
    }

    void copy_vertex(std::size_t vertex)
    {
        const auto repeat = [&](auto& stream) {
            if (!stream.empty()) stream.push_back(stream[vertex]);
        };
        repeat(mesh_.positions);
        repeat(mesh_.normals);
        repeat(mesh_.uv0);
        repeat(mesh_.colours);
    }

    MeshData& mesh_;
    float least_cosine_;
    std::vector<glm::vec3> units_;  ///< Of faces; zero without a plane.
    std::vector<double> areas_;     ///< Twice the area.
};

}  // namespace

void add_crease_normals(MeshData& mesh, float crease_rad)
{
    NormalMaker(mesh, crease_rad).make();
}

}  // namespace hw
