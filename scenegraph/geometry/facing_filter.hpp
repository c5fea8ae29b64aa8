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

    /// Decides 32 faces at a time: bit f of `facing_bits` is set where the viewer is for certain on the outer side of
    /// face f; faces that the filter cannot decide get a clear bit and go to `open_faces`, which must have room for all
    /// faces. Returns their number. `facing_bits` has room for a bit a face.
    std::uint32_t decide(const Viewpoint& viewpoint_object, std::span<std::uint32_t> facing_bits,
                         std::span<std::uint32_t> open_faces) const;

    std::uint32_t face_count() const { return face_count_; }
    std::size_t bytes() const { return 6 * sizeof(std::int16_t) * normal_[0].size(); }

 private:
    std::uint32_t face_count_ = 0;
    glm::dvec3 centre_{0.0};
    double step_ = 1.0;                                 // object units of one step of `anchor_`
    std::array<std::vector<std::int16_t>, 3> normal_;   // unit normals in steps of 1 / 32767; zero: never decided
    std::array<std::vector<std::int16_t>, 3> anchor_;   // a corner, from centre_ in steps
};

}  // namespace hw
