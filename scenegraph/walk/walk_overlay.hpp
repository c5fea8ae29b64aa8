#pragma once

#include <string>
#include <vector>

#include "hatchway/render/view/frame_stats.hpp"
#include "hatchway/render/view/overlay.hpp"

namespace hw {

/// What the words over the picture tell.
struct WalkFacts {
    bool is_mouse_captured = false;
    bool is_flying = false;
    bool is_playing_path = false;
    bool is_help_shown = false;
    bool are_statistics_shown = false;
    bool has_unsaved = false;
    std::string object;      ///< Under the cross-hair; empty: nothing.
    std::string style;       ///< Of it.
    double certainty = 1.0;  ///< Of it.
    double fps = 0.0;
    std::string quality;  ///< describe(FrameQuality).
    FrameStats stats;
    std::vector<std::string> cameras;   ///< By their digits, from 1.
    std::vector<std::string> problems;  ///< What is wrong now.
    std::string activity;               ///< What is prepared beside the drawing; empty: nothing.
    std::vector<std::string> notices;   ///< What happened just now.
    float width = 1280.0f;              ///< Of the window, logical pixels.
};

/// The words and the cross-hair. A function of the facts alone.
Overlay walk_overlay(const WalkFacts& facts);

/// `text` with line breaks so that no line is longer than `columns`; long words are cut.
std::string wrapped(const std::string& text, std::size_t columns);

}  // namespace hw
