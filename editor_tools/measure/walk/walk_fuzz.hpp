#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hatchway/walk/player.hpp"
#include "measure/walk/walk_oracle.hpp"

namespace hw::measure {

/// A walker: its state after `seconds` of an input. hw::step() with a body and a world; tests put broken ones here.
using Walker = std::function<PlayerState(const PlayerState&, const PlayerInput&, double seconds)>;

struct WalkFuzzOptions {
    std::uint64_t inputs = 1'000'000;
    std::uint32_t walks = 64;   ///< Among which the inputs are shared; each begins at a place of its own.
    double tolerance_m = 1e-4;  ///< What a body may reach into a triangle.
    double patience_s = 30.0;   ///< Random inputs that lead nowhere for so long start the attempts to get away.
    double freedom_m = 0.5;     ///< Who gets so far away is not stuck.
    std::uint32_t flying = 8;   ///< Every so many walks also flies, and drops where it is.
    std::uint32_t threads = 0;  ///< 0: all.
    std::uint32_t seed = 1;     ///< From 1. Another one draws other inputs for every walk.
};

/// Something that a walker did and must not do.
struct WalkFault {
    std::string what;  ///< A counter's name.
    std::uint32_t walk = 0;
    std::uint64_t input = 0;  ///< Of that walk.
    glm::dvec3 foot_world{0.0};
    double depth_m = 0.0;  ///< Of the body in a triangle there.
};

/// What happened. All counters from `put_back` to `stuck` must be 0.
struct WalkCounts {
    std::uint64_t inputs = 0;
    std::uint64_t frames = 0;
    double walked_s = 0.0;  ///< Of the walkers' time.
    double way_m = 0.0;
    std::uint64_t cells = 0;         ///< Of half a metre in which a foot has been.
    std::uint64_t put_back = 0;      ///< Times a walker fell into the void, or into a solid, and was put back.
    std::uint64_t lost = 0;          ///< Times a walker on foot got where nothing is below, and had to fly.
    std::uint64_t penetrations = 0;  ///< Frames at whose end a body reached into a triangle by more than the tolerance.
    double worst_depth_m = 0.0;
    std::uint64_t walls_crossed = 0;
    std::uint64_t floors_crossed = 0;  ///< Faces that are more level than upright, from either side.
    std::uint64_t thrown = 0;          ///< Ways longer than any speed allows, and put back though ground lay below.
    std::uint64_t eyes_parted = 0;     ///< Frames with a face between the eye and the body.
    std::uint64_t stuck = 0;           ///< Places from which no input led away, jumping included.
    std::vector<WalkFault> faults;     ///< The first few.

    std::uint64_t wrong() const
    {
        return put_back + lost + penetrations + walls_crossed + floors_crossed + thrown + eyes_parted + stuck;
    }
};

/// Random walks: keys that are held for random times, mouse, jumps, wheel, in frames of 1 to 100 ms. Every frame's end
/// is judged; where a frame's way looks wrong it is walked again tick by tick, and each tick is judged. A walk that is
/// stuck goes on at the next place. Walks are independent and spread over all threads; the counts do not depend on how.
WalkCounts fuzz_walk(const WalkOracle& oracle, const Walker& walker, const PlayerBody& body,
                     std::span<const PlayerState> starts, const WalkFuzzOptions& options);

}  // namespace hw::measure
