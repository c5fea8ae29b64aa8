#include "measure/hatching/surface_motion.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "measure/visibility/pvs_rays.hpp"

namespace hw {
namespace {

constexpr double kFlatCosine = 0.9995;
constexpr double kPlaneShare = 1e-3;  // off the plane, of the distance from the eye

/// A camera's pixels as rays.
struct Sight {
    Sight(const Camera& camera, glm::ivec2 size) : eye(camera.eye_world), size_px(size)
    {
        forward = glm::normalize(camera.target_world - camera.eye_world);
        right = glm::normalize(glm::cross(forward, glm::dvec3(0.0, 1.0, 0.0)));
        up = glm::cross(right, forward);
        focal_px = 0.5 * size.y / std::tan(0.5 * glm::radians(camera.fov_deg));
    }
    glm::dvec3 ray(const glm::dvec2& at_px) const
    {
        const glm::dvec2 off = at_px - 0.5 * glm::dvec2(size_px);
        return glm::normalize(focal_px * forward + off.x * right - off.y * up);
    }
    glm::dvec2 project(const glm::dvec3& place) const
    {
        const glm::dvec3 way = place - eye;
        const double depth = glm::dot(way, forward);
        return 0.5 * glm::dvec2(size_px) + focal_px / depth * glm::dvec2(glm::dot(way, right), -glm::dot(way, up));
    }

    glm::dvec3 eye;
    glm::dvec3 forward;
    glm::dvec3 right;
    glm::dvec3 up;
    double focal_px;
    glm::ivec2 size_px;
};

struct Hit {
    glm::dvec3 place;
    glm::dvec3 normal;
};

}  // namespace

struct SurfaceMotion::State {
    State(const Scene& scene, std::span<const MeshChunks> chunks)
        : triangles(measure::sight_triangles(scene, chunks)), rays(triangles)
    {
    }

    std::optional<Hit> hit(const glm::dvec3& eye, const glm::dvec3& way) const
    {
        std::vector<std::uint32_t> met;
        rays.trace(eye, way, met);
        std::optional<Hit> nearest;
        double least = 0.0;
        for (const std::uint32_t number : met) {
            const measure::SightTriangle& t = triangles[number];
            const glm::dvec3 normal = glm::normalize(glm::cross(t.b - t.a, t.c - t.a));
            const double distance = glm::dot(t.a - eye, normal) / glm::dot(way, normal);
            if (!std::isfinite(distance) || (nearest && distance >= least)) continue;
            least = distance;
            nearest = Hit{eye + distance * way, normal};
        }
        return nearest;
    }

    std::vector<measure::SightTriangle> triangles;
    measure::SightRays rays;
};

SurfaceMotion::SurfaceMotion(const Scene& scene, std::span<const MeshChunks> chunks)
    : state_(std::make_unique<State>(scene, chunks))
{
}

SurfaceMotion::~SurfaceMotion() = default;

std::optional<SeenTwice> SurfaceMotion::seen_twice(const Camera& before, const Camera& after, glm::ivec2 size_px,
                                                   const glm::dvec2& at_px) const
{
    const Sight sight(before, size_px);
    const Sight next(after, size_px);
    const std::optional<Hit> middle = state_->hit(sight.eye, sight.ray(at_px));
    if (!middle) return {};
    const double reach = kCoherenceReach + 1.0;
    const double allowed = kPlaneShare * glm::distance(middle->place, sight.eye);
    const auto on_plane = [&](const glm::dvec3& place) {
        return std::abs(glm::dot(place - middle->place, middle->normal)) <= allowed;
    };
    for (const glm::dvec2& step :
         {glm::dvec2(0, 0), glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(-1, 1), glm::dvec2(1, 1),
          glm::dvec2(0, 1), glm::dvec2(0, -1), glm::dvec2(1, 0), glm::dvec2(-1, 0)}) {
        const std::optional<Hit> there = state_->hit(sight.eye, sight.ray(at_px + reach * step));
        if (!there || !on_plane(there->place) || std::abs(glm::dot(there->normal, middle->normal)) < kFlatCosine)
            return {};
        const glm::dvec2 moved = next.project(there->place);
        if (moved.x < 1.0 || moved.y < 1.0 || moved.x > size_px.x - 1.0 || moved.y > size_px.y - 1.0) return {};
        const std::optional<Hit> again = state_->hit(next.eye, glm::normalize(there->place - next.eye));
        if (!again || glm::distance(again->place, there->place) > allowed) return {};
    }
    const auto moved = [&](const glm::dvec2& step) {
        const glm::dvec3 way = sight.ray(at_px + step);
        const double distance = glm::dot(middle->place - sight.eye, middle->normal) / glm::dot(way, middle->normal);
        return next.project(sight.eye + distance * way);
    };
    const glm::dvec2 place = moved({0.0, 0.0});
    return SeenTwice{at_px, place, moved({1.0, 0.0}) - place, moved({0.0, 1.0}) - place};
}

}  // namespace hw
