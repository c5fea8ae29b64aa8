// The nearest place on a line of sight is a linear programme with a closed form. With x to the right, z ahead and t the
// slope of the picture's side, a point is inside when |x - cx| <= t (z - cz). The two sides give cx - t cz >= max(x - t
// z) and -cx - t cz >= max(-x - t z): their sum bounds cz, their difference is cx. The same holds for y. The direction
// that does not bound cz has air to share, which a few steps then share evenly.
#include "hatchway/stage/whole_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <limits>

#include "hatchway/world/scene_places.hpp"

namespace hw {
namespace {

constexpr double kFovDeg = 40.0;
constexpr double kMargin = 1.06;                   // air around the scene
constexpr std::uint64_t kMaxVertices = 4'000'000;  // past that, boxes of objects are near enough
constexpr int kCentringSteps = 8;
constexpr double kTurnSeconds = 10.0;
constexpr int kTurnKeys = 24;  // a Catmull-Rom curve through 24 places leaves the circle by under a hundredth %
const glm::dvec3 kForward = -glm::normalize(glm::dvec3(0.5, 0.35, 0.8));

/// The camera's axes and, for each side of the picture, how far points reach out: left, right, bottom, top.
class Fit {
 public:
    explicit Fit(double aspect) : slope_y_(std::tan(glm::radians(kFovDeg) / 2.0) / kMargin), slope_x_(slope_y_ * aspect)
    {
        reach_.fill(-std::numeric_limits<double>::infinity());
    }

    void add(const glm::dvec3& point)
    {
        const double x = glm::dot(point, right_);
        const double y = glm::dot(point, up_);
        const double z = glm::dot(point, kForward);
        const std::array<double, 4> reach{-x - slope_x_ * z, x - slope_x_ * z, -y - slope_y_ * z, y - slope_y_ * z};
        for (std::size_t i = 0; i < reach.size(); ++i) reach_[i] = std::max(reach_[i], reach[i]);
    }

    const glm::dvec3& right() const { return right_; }
    const glm::dvec3& up() const { return up_; }

    glm::dvec3 eye() const
    {
        const double x = 0.5 * (reach_[1] - reach_[0]);
        const double y = 0.5 * (reach_[3] - reach_[2]);
        const double z = std::min(-(reach_[0] + reach_[1]) / (2 * slope_x_), -(reach_[2] + reach_[3]) / (2 * slope_y_));
        return x * right_ + y * up_ + z * kForward;
    }

 private:
    glm::dvec3 right_ = glm::normalize(glm::cross(kForward, glm::dvec3(0, 1, 0)));
    glm::dvec3 up_ = glm::cross(right_, kForward);
    double slope_y_;
    double slope_x_;
    std::array<double, 4> reach_;
};

glm::dvec3 corner(const Box& box, int index)
{
    return {(index & 1) ? box.max.x : box.min.x, (index & 2) ? box.max.y : box.min.y,
            (index & 4) ? box.max.z : box.min.z};
}

std::uint64_t vertex_count(const Scene& scene)
{
    std::uint64_t count = 0;
    for (const Object& object : scene.objects) count += scene.meshes[object.mesh].positions.size();
    return count;
}

bool is_inside(const glm::dvec3& point, const Box& box)
{
    const glm::dvec3 roundings = 1e-6 * box.size();
    return glm::all(glm::greaterThanEqual(point, box.min - roundings)) &&
           glm::all(glm::lessThanEqual(point, box.max + roundings));
}

/// Of what lies together.
template <typename Use>
void for_each_point(const Scene& scene, const Box& main_world, Use&& use_all)
{
    const auto use = [&](const glm::dvec3& point) {
        if (is_inside(point, main_world)) use_all(point);
    };
    const bool has_vertices = vertex_count(scene) <= kMaxVertices;
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const Object& object = scene.objects[id];
        if (has_vertices)
            for (const glm::vec3& position : scene.meshes[object.mesh].positions)
                use(glm::dvec3(scene.world_from_object(id) * glm::dvec4(glm::dvec3(position), 1.0)));
        else
            for (int i = 0; i < 8; ++i) use(corner(object.bounds_world, i));
    }
}

/// Moves the eye sideways until the scene reaches as far to the left as to the right, and as far up as down.
glm::dvec3 centred(const Scene& scene, const Box& main_world, const Fit& fit)
{
    glm::dvec3 eye = fit.eye();
    const double depth = glm::dot(main_world.centre() - eye, kForward);
    for (int step = 0; step < kCentringSteps; ++step) {
        glm::dvec2 min(std::numeric_limits<double>::infinity());
        glm::dvec2 max(-min);
        for_each_point(scene, main_world, [&](const glm::dvec3& point) {
            const glm::dvec3 arm = point - eye;
            const glm::dvec2 at =
                glm::dvec2(glm::dot(arm, fit.right()), glm::dot(arm, fit.up())) / glm::dot(arm, kForward);
            min = glm::min(min, at);
            max = glm::max(max, at);
        });
        // Half a step at a time: the outermost points are nearer or farther than the middle.
        const glm::dvec2 shift = 0.25 * depth * (min + max);
        if (!std::isfinite(shift.x) || !std::isfinite(shift.y)) return fit.eye();
        eye += shift.x * fit.right() + shift.y * fit.up();
    }
    return eye;
}

/// Looks from `eye` along the line of sight, at the depth of the scene's middle. A scene of one point is seen from a
/// metre.
CameraPlace looking(const glm::dvec3& eye, const Box& bounds)
{
    const double depth = glm::dot(bounds.centre() - eye, kForward);
    const double distance = depth > 1e-9 ? depth : 1.0;
    const glm::dvec3 target = eye + depth * kForward;
    return {target - distance * kForward, target, kFovDeg};
}

}  // namespace

CameraPlace whole_scene_camera(const Scene& scene, double aspect)
{
    if (scene.bounds_world.is_empty()) return {-kForward, glm::dvec3(0.0), kFovDeg};
    const Box main_world = find_places(scene).main_world;
    Fit fit(aspect);
    for_each_point(scene, main_world, [&](const glm::dvec3& point) { fit.add(point); });
    return looking(centred(scene, main_world, fit), main_world);
}

CameraPath turntable(const Scene& scene, double aspect)
{
    const Box bounds =
        scene.bounds_world.is_empty() ? Box{glm::dvec3(-0.1), glm::dvec3(0.1)} : find_places(scene).main_world;
    Fit fit(aspect);
    for (int key = 0; key < kTurnKeys; ++key) {
        const double angle = glm::radians(360.0) * key / kTurnKeys;
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 arm = corner(bounds, i) - bounds.centre();
            fit.add(bounds.centre() + glm::dvec3(std::cos(angle) * arm.x + std::sin(angle) * arm.z, arm.y,
                                                 std::cos(angle) * arm.z - std::sin(angle) * arm.x));
        }
    }
    // All turns together are symmetric about the vertical axis, so the line of sight meets it: there lies the target.
    CameraPlace start = looking(fit.eye(), bounds);
    const glm::dvec3 to_axis = bounds.centre() - start.eye_world;
    const double along = glm::dot(glm::dvec2(to_axis.x, to_axis.z), glm::dvec2(kForward.x, kForward.z)) /
                         glm::dot(glm::dvec2(kForward.x, kForward.z), glm::dvec2(kForward.x, kForward.z));
    start.target_world = start.eye_world + along * kForward;
    const glm::dvec3 arm = start.eye_world - start.target_world;

    CameraPath path;
    path.fov_deg = kFovDeg;
    for (int i = 0; i <= kTurnKeys; ++i) {
        const double angle = glm::radians(360.0) * (i % kTurnKeys) / kTurnKeys;
        const glm::dvec3 turned(std::cos(angle) * arm.x + std::sin(angle) * arm.z, arm.y,
                                std::cos(angle) * arm.z - std::sin(angle) * arm.x);
        path.keys.push_back({.t_s = kTurnSeconds * i / kTurnKeys,
                             .position = start.target_world + turned,
                             .look_at = start.target_world});
    }
    return path;
}

}  // namespace hw
