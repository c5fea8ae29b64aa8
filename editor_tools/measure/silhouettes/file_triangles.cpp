#include "measure/silhouettes/file_triangles.hpp"

#include <algorithm>

namespace hw {

FileTriangles::FileTriangles(const MeshData& mesh)
{
    const auto added = [&](std::uint32_t index) {
        const glm::vec3& p = mesh.positions[index];
        const auto [at, is_new] = numbers_.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(positions_.size()));
        if (is_new) positions_.push_back(p);
        return at->second;
    };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::array<std::uint32_t, 3> face{added(mesh.indices[i]), added(mesh.indices[i + 1]),
                                                added(mesh.indices[i + 2])};
        if (face[0] != face[1] && face[1] != face[2] && face[2] != face[0]) faces_.push_back(face);
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

}  // namespace hw
