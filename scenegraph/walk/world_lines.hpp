#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "hatchway/render/view/overlay.hpp"
#include "hatchway/stage/level_world.hpp"
#include "hatchway/style/view.hpp"
#include "hatchway/world/visibility/leak.hpp"
#include "hatchway/world/visibility/visibility.hpp"

namespace hw {

/// A line through the scene that explains the visibility; drawn over everything.
struct WorldLine {
    glm::dvec3 from_world{0.0};
    glm::dvec3 to_world{0.0};
    glm::vec4 colour{1.0f};  ///< sRGB and alpha.
    float width_px = 1.0f;
};

/// What is shown of a level's visibility.
struct WorldLineKinds {
    bool has_leaves = false;   ///< The BSP's leaves around the eye, from outside all; those of its cluster stand out.
    bool has_portals = false;  ///< The openings that sight flows through; those of the eye's place stand out.
    bool has_pvs = false;      ///< Boxes of the chunks that the PVS lets through from here, and, faint, of the others.
    bool has_wire = false;     ///< The triangles of the chunks that the PVS lets through.
};

/// The lines of a world's visibility from an eye.
std::vector<WorldLine> visibility_lines(const LevelWorld& world, const Visibility& visibility,
                                        const WorldLineKinds& kinds, const View& view);

/// The ways out of a level that ought to be sealed, a cross at each hole.
std::vector<WorldLine> leak_lines(std::span<const Leak> leaks);

/// Lines as the view shows them, in logical pixels of a picture of `size_px` (logical). What lies behind the eye is
/// cut.
std::vector<OverlayLine> projected(std::span<const WorldLine> lines, const View& view, const glm::vec2& size_px);

}  // namespace hw
