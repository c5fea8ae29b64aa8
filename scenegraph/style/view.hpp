#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace hw {

/// The viewpoint of a frame: a perspective, or a parallel projection (is_orthographic()).
struct View {
    glm::mat4 view_from_world{1.0f};
    glm::mat4 clip_from_view{1.0f};
    glm::dvec3 eye_world{0.0};
    /// In a parallel projection the direction from the scene to the viewer, any length; zero in perspective.
    glm::dvec3 to_viewer_world{0.0};
    glm::ivec2 size_px{1280, 720};  ///< Device pixels of the target.
    float px_scale = 1.0f;          ///< Device pixels for one logical pixel. Widths and spacings are logical.
    bool is_mirrored = false;       ///< The view of a mirror: front faces wind clockwise.
    double time_s = 0.0;            ///< The only clock a style may read, by Needs::clock.

    bool is_orthographic() const { return clip_from_view[3][3] == 1.0f; }
};

}  // namespace hw
