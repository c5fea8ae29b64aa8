#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace hw {

/// What facing is decided from beside positions and faces, made once.
struct FacingFilter {
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

    std::vector<Inherited> inherited;
    std::vector<Twin> twins;
};

}  // namespace hw
