#include "measure/hatching/surface_motion.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "measure/visibility/pvs_rays.hpp"

namespace hw {
namespace {

constexpr double kFlatCosine = 0.9995;
constexpr double kPlaneShare = 1e-3;    // off the plane, or the place, of the distance from the eye
constexpr double kSmoothCosine = 0.87;  // between the middle of a place and its border
constexpr double kUnsure_px = 0.05;

/// A camera's pixels as rays.
struct Sight {
    Sight(const Camera& camera, glm::ivec2 size) : eye(camera.eye_world), size_px(size)
    {
        forward = glm::normalize(camera.target_world - camera.eye_world);
        right = glm::normalize(glm::cross(forward, glm::dvec3(0.0, 1.0, 0.0)));
        const double roll = glm::radians(camera.roll_deg);
        right = std::cos(roll) * right + std::sin(roll) * glm::cross(right, forward);
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

/// Where a place around a pixel went, by rays.
struct Moved {
    glm::dvec2 to_px{0.0};
    Hit hit;
};

constexpr std::pair<double, double> kBetween[] = {{-0.5, -0.5}, {0.5, -0.5}, {-0.5, 0.5}, {0.5, 0.5},
                                                  {-1.0, 0.5},  {1.0, -0.5}, {0.5, 1.0},  {-0.5, -1.0}};

/// The motion of second order through nine places that are `reach` pixels apart.
SeenTwice bent(const glm::dvec2& at_px, const Moved (&grid)[3][3], double reach)
{
    const auto to = [&](int x, int y) { return grid[y + 1][x + 1].to_px; };
    const double square = reach * reach;
    SeenTwice seen{.before = at_px, .after = to(0, 0)};
    seen.right = (to(1, 0) - to(-1, 0)) / (2.0 * reach);
    seen.down = (to(0, 1) - to(0, -1)) / (2.0 * reach);
    seen.bend_right = (to(1, 0) + to(-1, 0) - 2.0 * to(0, 0)) / (2.0 * square);
    seen.bend_down = (to(0, 1) + to(0, -1) - 2.0 * to(0, 0)) / (2.0 * square);
    seen.bend_both = (to(1, 1) - to(-1, 1) - to(1, -1) + to(-1, -1)) / (4.0 * square);
    return seen;
}

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
    const Sight sight(before, size_px), next(after, size_px);
    const auto followed = [&](double i, double j) -> std::optional<Moved> {
        const std::optional<Hit> hit = state_->hit(sight.eye, sight.ray(at_px + glm::dvec2(i, j)));
        if (!hit) return {};
        const glm::dvec2 to_px = next.project(hit->place);
        if (to_px.x < 1.0 || to_px.y < 1.0 || to_px.x > size_px.x - 1.0 || to_px.y > size_px.y - 1.0) return {};
        const std::optional<Hit> again = state_->hit(next.eye, glm::normalize(hit->place - next.eye));
        const double allowed = kPlaneShare * glm::distance(hit->place, sight.eye);
        if (!again || glm::distance(again->place, hit->place) > allowed) return {};
        return Moved{to_px, *hit};
    };
    const double reach = kCoherenceReach + 1.0;
    Moved grid[3][3];
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x) {
            const auto place = followed((x - 1) * reach, (y - 1) * reach);
            if (!place) return {};
            grid[y][x] = *place;
        }
    SeenTwice seen = bent(at_px, grid, reach);
    const Hit& middle = grid[1][1].hit;
    const double allowed = kPlaneShare * glm::distance(middle.place, sight.eye);
    for (const auto& row : grid)
        for (const Moved& place : row) {
            const double cosine = std::abs(glm::dot(place.hit.normal, middle.normal));
            if (cosine < kSmoothCosine) return {};
            const double off = std::abs(glm::dot(place.hit.place - middle.place, middle.normal));
            seen.is_curved = seen.is_curved || cosine < kFlatCosine || off > allowed;
        }
    for (const auto& [i, j] : kBetween) {
        const auto place = followed(i * reach, j * reach);
        if (!place || glm::distance(place->to_px, seen.moved(i * reach, j * reach)) > kUnsure_px) return {};
    }
    return seen;
}

}  // namespace hw
