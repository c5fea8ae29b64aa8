#pragma once

#include <cstdint>

#include "hatchway/world/scene.hpp"

namespace hw {

/// What a frame of a walk has to do.
enum class FrameWork : std::uint8_t {
    paced,    ///< Draw as fast as it takes to look smooth.
    sharp,    ///< Draw once, as well as it can be.
    nothing,  ///< The picture is there already.
};

/// Since when nothing changed that the picture shows. A fresh one has just begun to move.
struct Stillness {
    double since_s = 0.0;
    FrameWork work = FrameWork::paced;
};

/// The state of the next frame, at `now_s` on a clock that never goes back. `has_changed`: the picture of now would not
/// be the last one. After a third of a second without change one sharp frame is drawn, then none.
Stillness after_moment(const Stillness& state, bool has_changed, double now_s);

/// Whether two cameras show the same but for rounding: a walker who stands is put back onto the floor at each step.
bool are_alike(const Camera& a, const Camera& b);

}  // namespace hw
