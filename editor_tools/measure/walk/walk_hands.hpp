#pragma once

#include <cstdint>
#include <random>

#include "hatchway/walk/player.hpp"

namespace hw::measure {

/// Keys and a mouse in random hands. The same seed gives the same inputs, with any library.
class WalkHands {
 public:
    explicit WalkHands(std::uint32_t seed) : random_(seed) {}

    /// The next input: some keys are pressed or let go, most stay.
    const PlayerInput& next();
    /// Whole frames for which the input is held.
    int frames() { return 1 + below(4); }
    /// From 1 to 100 ms, small ones as likely as large ones in proportion.
    double frame_s();
    /// Moves the mouse, for the coming frame.
    void move_mouse(PlayerInput& input);
    bool happens(double probability) { return share() < probability; }

 private:
    double share() { return random_() / 4294967296.0; }
    int below(std::uint32_t count) { return static_cast<int>(random_() % count); }
    double axis(double rest) { return happens(rest) ? 0.0 : happens(0.5) ? 1.0 : -1.0; }

    std::mt19937 random_;
    PlayerInput held_;
};

}  // namespace hw::measure
