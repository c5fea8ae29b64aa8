#include "measure/walk/walk_hands.hpp"

#include <cmath>

namespace hw::measure {
namespace {

constexpr double kChange = 0.15;     // of each key from one input to the next
constexpr double kTurnAbout = 0.01;  // of a frame

}  // namespace

const PlayerInput& WalkHands::next()
{
    if (happens(kChange)) held_.forward = happens(0.7) ? 1.0 : axis(0.5);
    if (happens(kChange)) held_.right = axis(0.6);
    if (happens(kChange)) held_.up = axis(0.4);
    if (happens(kChange)) held_.turn_left = axis(0.7);
    if (happens(kChange)) held_.turn_up = axis(0.8);
    if (happens(kChange)) held_.is_fast = happens(0.35);
    if (happens(kChange)) held_.wants_jump = happens(0.2);
    if (happens(0.1 * kChange)) held_.speed_factor = happens(0.7) ? 1.0 : std::pow(10.0, 2.0 * share() - 1.0);
    return held_;
}

double WalkHands::frame_s()
{
    return 1e-3 * std::pow(100.0, share());
}

void WalkHands::move_mouse(PlayerInput& input)
{
    const double reach = happens(kTurnAbout) ? 3.2 : 0.1;
    input.look_left_rad = reach * (2.0 * share() - 1.0);
    input.look_up_rad = 0.5 * reach * (2.0 * share() - 1.0);
}

}  // namespace hw::measure
