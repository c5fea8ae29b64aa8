#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "hatchway/geometry/exact/viewpoint.hpp"
#include "hatchway/geometry/surface/rounded_planes.hpp"

namespace hw {

/// What facing is decided from beside positions and faces, made once: planes in 16-bit steps, 8 bytes a face. They are
/// coarse, but by how much is known, so that almost every face is decided for certain from a fifth of the memory that
/// exact corners would take through the processor.
class FacingFilter {
 public:
    /// A face without a plane of its own takes the facing of `source`, one that has one, or kNoFace: back-facing.
    struct Inherited {
        std::uint32_t face;
        std::uint32_t source;
    };
    /// Where a surface cannot be oriented, an edge compares face A with B turned over: twin number i is face
    /// faces.size() + i.
    struct Twin {
        std::uint32_t face;
    };

    std::vector<Inherited> inherited;  ///< By rising face. To be known before prepare().
    std::vector<Twin> twins;

    /// Rounds the planes of `faces`.
    void prepare(std::span<const glm::vec3> positions, std::span<const std::array<std::uint32_t, 3>> faces);

    /// A viewpoint as the planes need it.
    EyeSteps eye_steps(const Viewpoint& viewpoint_object) const;

    const StepBlocks& planes() const { return planes_; }
    std::uint32_t face_count() const { return face_count_; }
    std::size_t bytes() const { return planes_.bytes(); }

 private:
    std::uint32_t face_count_ = 0;
    glm::dvec3 centre_{0.0};
    double radius_ = 1.0;  ///< Of the mesh around centre_: the unit of offsets.
    StepBlocks planes_;    ///< A face without one has that of its source.
};

}  // namespace hw
