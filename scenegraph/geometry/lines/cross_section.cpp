#include "hatchway/geometry/lines/cross_section.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/gtc/constants.hpp>

namespace hw {
namespace {

constexpr double kTurn = glm::two_pi<double>();
constexpr std::size_t kMostRays = 16;  // more directions around one line than that are no seam

enum class Vote { open, solid, unknown };

/// All faces that leave the line in one direction.
struct Ray {
    double angle_rad;
    bool looks_ccw;
    bool looks_cw;

    Vote ccw_side() const { return looks_ccw == looks_cw ? Vote::unknown : looks_ccw ? Vote::open : Vote::solid; }
    Vote cw_side() const { return looks_ccw == looks_cw ? Vote::unknown : looks_cw ? Vote::open : Vote::solid; }
};

struct Rays {
    std::array<Ray, kMostRays> ray;
    std::size_t count = 0;
    bool is_overfull = false;

    void add(const FaceAtLine& face, double flat_rad)
    {
        for (std::size_t i = 0; i < count; ++i) {
            const double apart = std::remainder(ray[i].angle_rad - face.angle_rad, kTurn);
            if (std::abs(apart) > flat_rad) continue;
            ray[i].looks_ccw |= face.looks_ccw;
            ray[i].looks_cw |= face.looks_cw;
            return;
        }
        if (count == kMostRays) {
            is_overfull = true;
            return;
        }
        ray[count++] = {face.angle_rad, face.looks_ccw, face.looks_cw};
    }
};

/// A sector at the back of a face is not where the eye is meant to be, also when another face looks into it: that one
/// stands inside of a solid or of an open shell.
bool is_open(Vote from, Vote to)
{
    return from != Vote::solid && to != Vote::solid;
}

}  // namespace

bool is_flat_across(std::span<const FaceAtLine> faces, double flat_rad)
{
    Rays rays;
    for (const FaceAtLine& face : faces) rays.add(face, flat_rad);
    if (rays.count < 2 || rays.is_overfull) return false;
    std::sort(rays.ray.begin(), rays.ray.begin() + rays.count,
              [](const Ray& a, const Ray& b) { return a.angle_rad < b.angle_rad; });
    bool is_seen = false;
    for (std::size_t i = 0; i < rays.count; ++i) {
        const Ray& ray = rays.ray[i];
        const Ray& next = rays.ray[(i + 1) % rays.count];
        if (!is_open(ray.ccw_side(), next.cw_side())) continue;
        is_seen = true;
        const double span = next.angle_rad - ray.angle_rad + (i + 1 == rays.count ? kTurn : 0.0);
        if (std::abs(span - glm::pi<double>()) > flat_rad) return false;
    }
    return is_seen;
}

}  // namespace hw
