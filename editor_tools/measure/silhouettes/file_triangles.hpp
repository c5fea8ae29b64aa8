#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "hatchway/geometry/mesh_data.hpp"
#include "measure/silhouettes/silhouette_oracle.hpp"

namespace hw {

/// The triangles of a file as they are, for the oracle: equal positions are one, and triangles with two equal corners
/// are left out. Nothing is turned, stitched or repaired, and no code of geometry/surface is used.
class FileTriangles {
 public:
    explicit FileTriangles(const MeshData& mesh);

    /// Of a position that no triangle of the file has.
    static constexpr std::uint32_t kNowhere = 0xffffffffu;

    const std::vector<glm::vec3>& positions() const { return positions_; }
    const std::vector<std::array<std::uint32_t, 3>>& faces() const { return faces_; }

    /// Edges between other positions as edges of the file, sorted, each once.
    std::vector<OracleEdge> edges_between(const std::vector<glm::vec3>& positions,
                                          const std::vector<OracleEdge>& edges) const;

 private:
    std::uint32_t number_of(const glm::vec3& position) const;

    std::vector<glm::vec3> positions_;
    std::vector<std::array<std::uint32_t, 3>> faces_;
    std::map<std::array<float, 3>, std::uint32_t> numbers_;
};

}  // namespace hw
