#include "hatchway/world/camera_path.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace hw {
namespace {

struct Segment {
    std::size_t first = 0;
    double share = 0.0;  ///< 0 at the first key, 1 at the next.
};

Segment segment_at(const CameraPath& path, double t_s)
{
    if (path.keys.size() < 2 || t_s <= path.keys.front().t_s) return {0, 0.0};
    std::size_t first = 0;
    while (first + 2 < path.keys.size() && path.keys[first + 1].t_s <= t_s) ++first;
    const double from = path.keys[first].t_s;
    const double to = path.keys[first + 1].t_s;
    return {first, std::clamp((t_s - from) / (to - from), 0.0, 1.0)};
}

/// Change of position per second at a key: the chord between its neighbours.
glm::dvec3 tangent(const CameraPath& path, std::size_t key)
{
    const PathKey& before = path.keys[key == 0 ? 0 : key - 1];
    const PathKey& after = path.keys[std::min(key + 1, path.keys.size() - 1)];
    return (after.position - before.position) / (after.t_s - before.t_s);
}

glm::dvec3 position_at(const CameraPath& path, const Segment& segment)
{
    const PathKey& a = path.keys[segment.first];
    if (path.keys.size() < 2) return a.position;
    const PathKey& b = path.keys[segment.first + 1];
    const double s = segment.share;
    const double duration = b.t_s - a.t_s;
    return (2 * s * s * s - 3 * s * s + 1) * a.position +
           (s * s * s - 2 * s * s + s) * duration * tangent(path, segment.first) +
           (3 * s * s - 2 * s * s * s) * b.position + (s * s * s - s * s) * duration * tangent(path, segment.first + 1);
}

struct Gaze {
    glm::dvec3 direction{0.0, 0.0, -1.0};
    double distance = 1.0;
};

Gaze gaze_of(const PathKey& key)
{
    const glm::dvec3 way = key.look_at - key.position;
    const double distance = glm::length(way);
    return distance > 0.0 ? Gaze{way / distance, distance} : Gaze{};
}

/// Any direction square to `direction`, level where there is one.
glm::dvec3 sideways(const glm::dvec3& direction)
{
    const glm::dvec3 level(direction.z, 0.0, -direction.x);
    const double length = glm::length(level);
    return length > 1e-9 ? level / length : glm::dvec3(1.0, 0.0, 0.0);
}

glm::dvec3 slerp(const glm::dvec3& a, const glm::dvec3& b, double share)
{
    const double cosine = std::clamp(glm::dot(a, b), -1.0, 1.0);
    glm::dvec3 side = b - cosine * a;
    const double length = glm::length(side);
    if (length < 1e-9 && cosine > 0.0) return a;
    side = length < 1e-9 ? sideways(a) : side / length;
    const double angle = std::acos(cosine) * share;
    return glm::normalize(std::cos(angle) * a + std::sin(angle) * side);
}

}  // namespace

Camera camera_at(const CameraPath& path, double t_s)
{
    const Segment segment = segment_at(path, t_s);
    const Gaze from = gaze_of(path.keys[segment.first]);
    const Gaze to = gaze_of(path.keys[std::min(segment.first + 1, path.keys.size() - 1)]);
    Camera camera;
    camera.fov_deg = path.fov_deg;
    camera.eye_world = position_at(path, segment);
    const double distance = from.distance + (to.distance - from.distance) * segment.share;
    camera.target_world = camera.eye_world + slerp(from.direction, to.direction, segment.share) * distance;
    return camera;
}

int path_frame_count(const CameraPath& path)
{
    const double duration = path.keys.back().t_s - path.keys.front().t_s;
    // A little slack: 0.1 s at 30 frames a second is not quite three frames in binary.
    return static_cast<int>(std::floor(path.fps * duration + 1e-6)) + 1;
}

double path_frame_time(const CameraPath& path, int frame)
{
    return std::min(path.keys.front().t_s + frame / path.fps, path.keys.back().t_s);
}

}  // namespace hw
