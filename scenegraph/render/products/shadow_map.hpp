#pragma once

#include <optional>
#include <span>

#include "hatchway/gl/gpu_state.hpp"
#include "hatchway/gl/gpu_target.hpp"
#include "hatchway/render/device/gpu_scene.hpp"
#include "hatchway/render/view/frame_block.hpp"
#include "hatchway/world/scene_places.hpp"

namespace hw {

/// The shadow map of the main light. It covers what lies together where the eye is (place_around()), in most scenes
/// all; the scene stands still, so it is drawn once for a place and kept. Its casters follow from the light alone:
/// every opaque or masked object, seen or not.
class ShadowMap {
 public:
    static constexpr int kSidePx = 4096;
    /// Enough to try styles with: thousands of objects at one place fill a map thousands of times.
    static constexpr int kRehearsalSidePx = 64;

    /// Draws the map when it is not there yet for the eye's place with that side, or with half of it, a quarter and so
    /// on where casters lie over each other so often that all would take long. `left_out`: VisibilityQuery.
    void prepare(const Scene& scene, const glm::dvec3& eye_world, std::span<const std::uint8_t> left_out,
                 GpuScene& gpu_scene, const SceneLight& light, ProgramStore& programs, GpuState& state,
                 int side_px = kSidePx);

    const ShadowFrame& frame() const { return frame_; }
    std::uint32_t texture() const { return frame_.is_drawn ? target_.depth().id() : 0; }
    int drawn_count() const { return drawn_count_; }

 private:
    std::optional<ScenePlaces> places_;  ///< Once they are asked for.
    Box place_world_;                    ///< That was drawn.
    GpuTarget target_;
    ShadowFrame frame_;
    int wanted_side_px_ = 0;  ///< When it was drawn.
    int drawn_count_ = 0;
};

/// Where a sun's map looks: an orthographic view along the light around `bounds_world`, whatever the eye sees.
/// Returns clip from world.
glm::dmat4 sun_clip_from_world(const glm::dvec3& direction_world, const Box& bounds_world);

}  // namespace hw
