#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <span>

#include "hatchway/geometry/mesh_chunks.hpp"
#include "hatchway/world/scene.hpp"
#include "measure/hatching/coherence_error.hpp"

namespace hw {

/// Where places of a scene's surface go in the picture when the camera moves, by rays: what hatching is judged by.
class SurfaceMotion {
 public:
    /// `chunks`: one for each mesh of the scene.
    SurfaceMotion(const Scene& scene, std::span<const MeshChunks> chunks);
    ~SurfaceMotion();

    /// The place under `at_px`. Nothing where its surroundings are no smooth surface, or are hidden or outside after
    /// the move. Nine rays say how they move, eight more that nothing between moves otherwise by more than a twentieth
    /// of a pixel.
    std::optional<SeenTwice> seen_twice(const Camera& before, const Camera& after, glm::ivec2 size_px,
                                        const glm::dvec2& at_px) const;

 private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace hw
