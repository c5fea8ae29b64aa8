// The proof of the bound. A face has the unit normal n and a corner p; c is the middle of the mesh and r its radius. An
// eye at x is on the outer side when t = n . (x - c) - n . (p - c) > 0. Stored are N = round(32767 n) and D =
// round(32767 n . (p - c) / r); the eye becomes e = round(k (x - c)), w = round(k r) for a factor k > 0. Then s = N . e
// - D w, computed without rounding, is close to T = 32767 k t:
//   |N - 32767 n| <= sqrt(3)/2 + 0.07      rounding, and the normal itself from doubles to 2e-6 (else N = D = 0)
//   |D - 32767 n . (p - c) / r| <= 1/2 + 0.07    the same, with |p - c| <= r
//   |e - k (x - c)| <= sqrt(3)/2 + 0.001, |w - k r| <= 1/2 + 0.001    rounding, and the doubles before it
// so |s - T| <= 0.937 |e| + 0.57 w + 32767 (0.868 + 0.501), and eye_steps() takes more than that. For an orthographic
// view w = 0 exactly, and offsets play no part.
#include "hatchway/geometry/surface/facing_filter.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "hatchway/core/box.hpp"

namespace hw {
namespace {

constexpr double kSteps = 32767.0;
constexpr double kMostSum = 65530.0;  // of the magnitudes of an eye, with room for rounding up

using Corners = std::array<std::uint32_t, 3>;

/// The unit normal, or zero where doubles cannot tell it to 2e-6.
glm::dvec3 sure_normal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const glm::dvec3 p = b - a, q = c - a;
    const glm::dvec3 normal = glm::cross(p, q);
    const double length = glm::length(normal);
    constexpr double kSharpest = 1e-9;  // sine of the corner below which rounding is over 2e-6 of the normal
    if (!(length > kSharpest * glm::length(p) * glm::length(q)) || !(length > 1e-280)) return glm::dvec3(0.0);
    return normal / length;
}

std::int16_t steps(double value)
{
    return static_cast<std::int16_t>(value + (value < 0.0 ? -0.5 : 0.5));
}

RoundedPlane rounded_plane(std::span<const glm::vec3> positions, const Corners& face, const glm::dvec3& centre,
                           double radius)
{
    const glm::dvec3 a = positions[face[0]], b = positions[face[1]], c = positions[face[2]];
    const glm::dvec3 normal = sure_normal(a, b, c);
    const double offset = std::clamp(glm::dot(normal, a - centre) / radius, -1.0, 1.0);
    return {steps(kSteps * normal.x), steps(kSteps * normal.y), steps(kSteps * normal.z), steps(kSteps * offset)};
}

}  // namespace

void FacingFilter::prepare(std::span<const glm::vec3> positions, std::span<const Corners> faces)
{
    face_count_ = static_cast<std::uint32_t>(faces.size());
    Box box;
    for (const glm::vec3& p : positions) box.add(glm::dvec3(p));
    centre_ = positions.empty() ? glm::dvec3(0.0) : box.centre();
    radius_ = 1e-300;
    for (const glm::vec3& p : positions) radius_ = std::max(radius_, glm::distance(glm::dvec3(p), centre_));
    auto next = inherited.begin();
    for (std::uint32_t face = 0; face < face_count_; ++face) {
        std::uint32_t source = face;
        if (next != inherited.end() && next->face == face) source = (next++)->source;
        const bool has_plane = source < face_count_;
        planes_.add(has_plane ? rounded_plane(positions, faces[source], centre_, radius_) : RoundedPlane{});
    }
}

EyeSteps FacingFilter::eye_steps(const Viewpoint& viewpoint_object) const
{
    const bool is_direction = viewpoint_object.is_orthographic;
    const glm::dvec3 eye = is_direction ? viewpoint_object.eye : viewpoint_object.eye - centre_;
    const double radius = is_direction ? 0.0 : radius_;
    const glm::dvec3 size = glm::abs(eye);
    const double largest = std::max({size.x, size.y, size.z, radius}), sum = size.x + size.y + size.z + radius;
    if (!(largest > 0.0)) return {{}, std::numeric_limits<std::int32_t>::max()};
    // Of unequal sizes the small ones lose no more than steps; dividing first keeps tiny and huge eyes in range.
    const double factor = std::min(kSteps, kMostSum / (sum / largest));
    const glm::dvec3 scaled = eye / largest * factor;
    const EyeSteps result{{steps(scaled.x), steps(scaled.y), steps(scaled.z), steps(-radius / largest * factor)}, 0};
    const double offset_error = is_direction ? 0.0 : 0.51 * kSteps - 0.58 * result.eye[3];
    const double bound = 0.95 * (glm::length(scaled) + 1.0) + 0.88 * kSteps + offset_error;
    return {result.eye, static_cast<std::int32_t>(bound) + 1};
}

}  // namespace hw
