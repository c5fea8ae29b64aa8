#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "hatchway/geometry/mesh_data.hpp"
#include "measure/silhouettes/silhouette_oracle.hpp"

namespace hw {

/// The triangles of a file as they are, for the oracle: equal positions are one, triangles with two equal corners are
/// left out, and of those with the same three corners the first stays. Nothing is turned, stitched or repaired, and no
/// code of geometry/surface is used.
class FileTriangles {
 public:
    explicit FileTriangles(const MeshData& mesh);

    /// Of a position that no triangle of the file has.
    static constexpr std::uint32_t kNowhere = 0xffffffffu;

    /// Triangles that have the same corners as an earlier one.
    std::size_t doubled() const { return doubled_; }

    const std::vector<glm::vec3>& positions() const { return positions_; }
    const std::vector<std::array<std::uint32_t, 3>>& faces() const { return faces_; }

    /// Edges between other positions as edges of the file, sorted, each once.
    std::vector<OracleEdge> edges_between(const std::vector<glm::vec3>& positions,
                                          const std::vector<OracleEdge>& edges) const;

    /// Edges that a repair of the mesh changed, sorted: where a repaired face is none of the file's, where one of the
    /// file's is missing, or where a face took the plane of another (`is_own[face]` is false).
    std::vector<OracleEdge> changed_edges(const std::vector<glm::vec3>& positions,
                                          const std::vector<std::array<std::uint32_t, 3>>& faces,
                                          const std::vector<bool>& is_own) const;

 private:
    std::uint32_t number_of(const glm::vec3& position) const;

    std::vector<glm::vec3> positions_;
    std::vector<std::array<std::uint32_t, 3>> faces_;
    std::size_t doubled_ = 0;
    std::map<std::array<float, 3>, std::uint32_t> numbers_;
};

}  // namespace hw
