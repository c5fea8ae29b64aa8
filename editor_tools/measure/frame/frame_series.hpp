#pragma once

#include <functional>
#include <span>
#include <vector>

#include "hatchway/render/renderer.hpp"

namespace hw::measure {

/// One way to draw a level.
struct FrameVariant {
    Renderer* renderer = nullptr;  ///< Has loaded the level.
    bool use_pvs = true;
};

/// What a variant's frames took.
struct FrameSeries {
    std::vector<FrameStats> frames;
    double unlike_share = 0.0;  ///< Pixels that differ from the first variant's pictures, mean.
};

/// Draws all views in every variant, one frame of each after the other, so that a slow moment of the machine meets all.
/// `told` is called after each view; it may be empty.
std::vector<FrameSeries> draw_in_turn(std::span<const FrameVariant> variants, std::span<const View> views, int samples,
                                      const std::function<void()>& told = {});

}  // namespace hw::measure
