#include "measure/silhouettes/file_triangles.hpp"

#include <algorithm>
#include <iterator>
#include <set>

namespace hw {
namespace {

using Corners = std::array<std::uint32_t, 3>;

Corners sorted(Corners corners)
{
    std::sort(corners.begin(), corners.end());
    return corners;
}

}  // namespace

FileTriangles::FileTriangles(const MeshData& mesh)
{
    const auto added = [&](std::uint32_t index) {
        const glm::vec3& p = mesh.positions[index];
        const auto [at, is_new] = numbers_.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(positions_.size()));
        if (is_new) positions_.push_back(p);
        return at->second;
    };
    std::set<Corners> known;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const Corners face{added(mesh.indices[i]), added(mesh.indices[i + 1]), added(mesh.indices[i + 2])};
        if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) continue;
        if (known.insert(sorted(face)).second)
            faces_.push_back(face);
        else
            ++doubled_;
    }
}

std::uint32_t FileTriangles::number_of(const glm::vec3& position) const
{
    const auto found = numbers_.find({position.x, position.y, position.z});
    return found == numbers_.end() ? kNowhere : found->second;
}

std::vector<OracleEdge> FileTriangles::edges_between(const std::vector<glm::vec3>& positions,
                                                     const std::vector<OracleEdge>& edges) const
{
    std::vector<OracleEdge> result;
    for (const auto& [u, v] : edges) {
        const std::uint32_t a = number_of(positions[u]), b = number_of(positions[v]);
        result.push_back({std::min(a, b), std::max(a, b)});
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

std::vector<OracleEdge> FileTriangles::changed_edges(const std::vector<glm::vec3>& positions,
                                                     const std::vector<Corners>& faces,
                                                     const std::vector<bool>& is_own) const
{
    std::vector<Corners> in_file, repaired, unlike;
    for (const Corners& face : faces_) in_file.push_back(sorted(face));
    for (std::size_t i = 0; i < faces.size(); ++i) {
        Corners face;
        for (std::size_t k = 0; k < 3; ++k) face[k] = number_of(positions[faces[i][k]]);
        (is_own[i] ? repaired : unlike).push_back(sorted(face));
    }
    std::sort(in_file.begin(), in_file.end());
    std::sort(repaired.begin(), repaired.end());
    std::set_symmetric_difference(in_file.begin(), in_file.end(), repaired.begin(), repaired.end(),
                                  std::back_inserter(unlike));
    std::vector<OracleEdge> edges;
    for (const auto& [a, b, c] : unlike) edges.insert(edges.end(), {{a, b}, {a, c}, {b, c}});
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

}  // namespace hw
