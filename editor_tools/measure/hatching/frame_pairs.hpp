#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

#include "hatchway/world/level.hpp"
#include "measure/hatching/surface_motion.hpp"

namespace hw {

/// Two neighbouring frames, and places of the surface that both see.
struct FramePair {
    std::string path;  ///< The path's name, or kAtCameras.
    Camera before;
    Camera after;
    std::vector<SeenTwice> places;

    static constexpr const char* kAtCameras = "cameras";
};

/// `count` pairs, spread evenly over a path: neighbouring frames of its own.
std::vector<FramePair> pairs_along(const CameraPath& path, int count);

/// Two pairs at each perspective camera: a step ahead and one to the side, each with a turn. As far as a walker gets
/// between two of 25 frames a second.
std::vector<FramePair> pairs_at(std::span<const Camera> cameras);

/// Tries `tries` pixels of each pair, always the same ones.
void find_places(std::vector<FramePair>& pairs, const SurfaceMotion& motion, glm::ivec2 size_px, int tries);

}  // namespace hw
