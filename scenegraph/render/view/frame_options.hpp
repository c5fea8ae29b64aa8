#pragma once

#include <optional>

#include "hatchway/render/view/overlay.hpp"
#include "hatchway/style/needs.hpp"

namespace hw {

/// How lines reach the picture. `native`: as GL_LINES, the way of 2001, where the device draws them that wide and the
/// look is ruled; else as quads.
enum class LinePath : unsigned char { quads, native };

/// How far the depth that lines are tested against lies behind the faces, as a polygon offset.
struct FaceOffset {
    float factor = 0.75f;
    float units = 4.0f;
};

struct FrameOptions {
    int samples = 4;  ///< 1 or 4; fewer where the device has no more.
    bool use_pvs = true;
    bool skips_hidden = true;  ///< Leaves objects unshaded that others hide, where that pays. Never changes a pixel.
    LinePath line_path = LinePath::quads;
    FaceOffset line_offset;
    bool is_timed = false;  ///< Wait for the device after each phase, so that phases can be told apart.
    Overlay overlay;
    bool is_rehearsal = false;            ///< What styles say in vain is remarked, too, and remarks are not logged.
    std::optional<ImageKey> shown_image;  ///< Shown in place of the picture: an image of the frame.
};

}  // namespace hw
