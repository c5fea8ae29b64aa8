#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hatchway/style/view.hpp"
#include "hatchway/world/visibility/visibility.hpp"
#include "measure/visibility/pvs_rays.hpp"

namespace hw::measure {

/// What a view holds, in triangles of the scene, each once.
struct SightCounts {
    std::uint64_t in_view = 0;  ///< Drawn without the PVS: of chunks that the frustum meets.
    std::uint64_t drawn = 0;    ///< Drawn with it.
    std::uint64_t needed = 0;   ///< Of pieces of 64 triangles of a chunk of which a ray met one.
    std::uint64_t met = 0;      ///< That a ray met.
    std::uint64_t rays = 0;
    std::uint64_t lost = 0;  ///< Chunks that a ray meets and the PVS hides, confirmed by rational numbers.

    void add(const SightCounts& other);
};

/// Says what is truly seen, by rays through all pixels. Beside the places of the triangles it shares nothing with what
/// draws.
class SightJudge {
 public:
    /// All must outlive this.
    SightJudge(const Scene& scene, std::span<const MeshChunks> chunks_of_mesh, const Visibility& visibility);

    /// One ray through the middle of each pixel of `size_px`, which need not be the view's own. Perspective views.
    SightCounts judge(const View& view, const glm::ivec2& size_px) const;

 private:
    std::uint64_t triangles_in(const View& view, const Visibility* visibility) const;
    void count_met(const std::vector<std::uint8_t>& is_met, SightCounts& counts) const;

    const Scene& scene_;
    std::span<const MeshChunks> chunks_;
    const Visibility& visibility_;
    std::vector<SightTriangle> triangles_;
    SightRays rays_;
    std::vector<Box> mesh_bounds_;
};

}  // namespace hw::measure
