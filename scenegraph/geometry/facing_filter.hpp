#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "geometry/viewpoint.hpp"

namespace hw {

/// What facing is decided from beside positions and faces, made once: planes in 16-bit steps, 12 bytes a face. They are
/// coarse, but by how much is known, so that almost every face is decided for certain from a quarter of the memory that
/// exact corners would take through the processor.
class FacingFilter {
 public:
    /// A collinear face has no plane: it takes the facing of `source`, a face with a plane, or kNoFace: back-facing.
    struct Inherited {
        std::uint32_t face;
        std::uint32_t source;
    };
    /// Where a surface cannot be oriented, an edge compares face A with B turned over: twin number i is face
    /// faces.size() + i.
    struct Twin {
        std::uint32_t face;
    };

    std::vector<Inherited> inherited;  ///< By rising face.
    std::vector<Twin> twins;

    /// Rounds the planes of `faces`.
    void prepare(std::span<const glm::vec3> positions, std::span<const std::array<std::uint32_t, 3>> faces);

    static constexpr std::uint32_t kBlock = 32;  ///< Faces that are decided together.

    /// A viewpoint as the filter needs it.
    struct Query {
        glm::vec3 eye{0.0f};         ///< In steps from the middle of the mesh; a direction for orthographic views.
        float anchor_weight = 1.0f;  ///< 0 for orthographic views, whose faces need no anchor.
        float bound = 0.0f;          ///< What is farther from 0 is certain.
    };
    Query query(const Viewpoint& viewpoint_object) const;

    /// Decides the faces of some blocks: facing[f] becomes 1 where the viewer is for certain on the outer side of face
    /// f, else 0. Faces that the filter cannot decide are appended to `open_faces` at `open_count`, which is returned
    /// raised. Both have room for all faces, rounded up to blocks.
    std::uint32_t decide(const Query& query, std::uint32_t first_block, std::uint32_t block_count,
                         std::span<std::uint8_t> facing, std::span<std::uint32_t> open_faces,
                         std::uint32_t open_count) const;

    std::uint32_t block_count() const { return (face_count_ + kBlock - 1) / kBlock; }
    std::uint32_t face_count() const { return face_count_; }
    std::size_t bytes() const { return 6 * sizeof(std::int16_t) * normal_[0].size(); }

 private:
    std::uint32_t face_count_ = 0;
    glm::dvec3 centre_{0.0};
    double step_ = 1.0;                                // object units of one step of `anchor_`
    std::array<std::vector<std::int16_t>, 3> normal_;  // unit normals in steps of 1 / 32767; zero: never decided
    std::array<std::vector<std::int16_t>, 3> anchor_;  // a corner, from centre_ in steps
};

}  // namespace hw
