#include "measure/hatching/frame_pairs.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "hatchway/world/camera_path.hpp"

namespace hw {
namespace {

constexpr double kStep_m = 1.4 / 25.0;     // a visitor's pace
constexpr double kTurn = 0.5 * 0.0174533;  // radians between two frames
constexpr double kBorder_px = 16.0;        // a place needs its surroundings

Camera moved(const Camera& camera, const glm::dvec3& step)
{
    const glm::dvec3 look = camera.target_world - camera.eye_world;
    const double c = std::cos(kTurn), s = std::sin(kTurn);
    Camera next = camera;
    next.eye_world += step;
    next.target_world = next.eye_world + glm::dvec3(c * look.x + s * look.z, look.y, c * look.z - s * look.x);
    return next;
}

}  // namespace

std::vector<FramePair> pairs_along(const CameraPath& path, int count)
{
    const int frames = path_frame_count(path);
    std::vector<FramePair> pairs;
    for (int i = 0; i < count; ++i) {
        const int frame = static_cast<int>((frames - 2LL) * (2LL * i + 1) / (2LL * count));
        pairs.push_back({path.name,
                         camera_at(path, path_frame_time(path, frame)),
                         camera_at(path, path_frame_time(path, frame + 1)),
                         {}});
    }
    return pairs;
}

std::vector<FramePair> pairs_at(std::span<const Camera> cameras)
{
    std::vector<FramePair> pairs;
    for (const Camera& camera : cameras) {
        const glm::dvec3 look = camera.target_world - camera.eye_world;
        const double flat = std::hypot(look.x, look.z);
        if (camera.orthographic_height_m || flat == 0.0) continue;
        const glm::dvec3 ahead(look.x / flat, 0.0, look.z / flat), side(-ahead.z, 0.0, ahead.x);
        for (const glm::dvec3& way : {ahead, side})
            pairs.push_back({FramePair::kAtCameras, camera, moved(camera, kStep_m * way), {}});
    }
    return pairs;
}

void find_places(std::vector<FramePair>& pairs, const SurfaceMotion& motion, glm::ivec2 size_px, int tries)
{
    std::mt19937 random(1);
    const auto within = [&](int side) { return kBorder_px + (side - 2.0 * kBorder_px) * (random() / 4294967296.0); };
    for (FramePair& pair : pairs)
        for (int i = 0; i < tries; ++i) {
            const double x = within(size_px.x);
            const glm::dvec2 at(x, within(size_px.y));
            if (const auto place = motion.seen_twice(pair.before, pair.after, size_px, at))
                pair.places.push_back(*place);
        }
}

}  // namespace hw
