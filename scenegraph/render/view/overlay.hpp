#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

namespace hw {

/// Text over the picture, in a fixed font of 12 x 16 logical pixels. '\n' starts a new line; characters outside of
/// ASCII show as '?'.
struct OverlayText {
    glm::vec2 position_px{8.0f};  ///< Logical pixels from the top left corner; negative: from the right or bottom edge.
    std::string text;
    glm::vec4 colour{1.0f, 1.0f, 1.0f, 1.0f};  ///< sRGB and alpha.
    glm::vec4 background{0.0f, 0.0f, 0.0f, 0.6f};

    bool operator==(const OverlayText&) const = default;
};

/// A straight line over the picture, in logical pixels from the top left corner.
struct OverlayLine {
    glm::vec2 from_px{0.0f};
    glm::vec2 to_px{0.0f};
    glm::vec4 colour{1.0f, 1.0f, 1.0f, 1.0f};  ///< sRGB and alpha.
    float width_px = 1.0f;

    bool operator==(const OverlayLine&) const = default;
};

/// What is drawn over a finished picture: lines, then texts.
struct Overlay {
    std::vector<OverlayLine> lines;
    std::vector<OverlayText> texts;
    bool has_cross_hair = false;

    bool operator==(const Overlay&) const = default;
};

}  // namespace hw
