// A plane through side i of the source makes an angle with it. In the frame of the side (L: inwards in the source's
// plane, N: the source's normal) each corner of the pass is a point (beta, alpha); the separating plane goes through
// the one that leans furthest inwards, largest beta / alpha. Every other corner is then in front and the source behind,
// because it is convex: nothing is left to test.
#include "hatchway/world/visibility/tree/portal_polygon.hpp"

#include <cmath>

namespace hw {
namespace {

constexpr double kTouching = 1e-9;   // a corner so near to the side's line does not tilt a plane through that line
constexpr double kUncertain = 1e-6;  // one as near as this would tilt it by rounding noise: no plane at all

/// The planar hull of many corners: a rectangle around them in their plane, larger than they are.
void enclose(std::span<const glm::dvec3> corners, Winding& winding)
{
    glm::dvec3 normal(0.0);
    for (std::size_t i = 2; i < corners.size(); ++i) {
        normal += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    }
    normal = glm::normalize(normal);
    const glm::dvec3 u = glm::normalize(corners[1] - corners[0]);
    const glm::dvec3 v = glm::cross(normal, u);
    double least_u = 0.0, most_u = 0.0, least_v = 0.0, most_v = 0.0;
    for (const glm::dvec3& corner : corners) {
        const glm::dvec3 way = corner - corners[0];
        least_u = std::min(least_u, glm::dot(way, u));
        most_u = std::max(most_u, glm::dot(way, u));
        least_v = std::min(least_v, glm::dot(way, v));
        most_v = std::max(most_v, glm::dot(way, v));
    }
    winding.count = 4;
    winding.points[0] = corners[0] + least_u * u + least_v * v;
    winding.points[1] = corners[0] + most_u * u + least_v * v;
    winding.points[2] = corners[0] + most_u * u + most_v * v;
    winding.points[3] = corners[0] + least_u * u + most_v * v;
}

/// The plane through side i of the source that parts it from the pass; false if there is none that is certain.
bool separator(const Separation& between, const std::array<double, Winding::kMostCorners>& alphas, int i,
               FlowPlane& plane)
{
    const Winding& source = between.source;
    const glm::dvec3& from = source[i];
    const glm::dvec3 side = source[i + 1 == source.count ? 0 : i + 1] - from;
    const double squared = glm::dot(side, side);
    if (squared < kUncertain * kUncertain) return false;
    glm::dvec3 inwards = glm::cross(between.source_plane.normal, side) / std::sqrt(squared);
    if (between.is_reversed) inwards = -inwards;
    bool is_found = false;
    double best_alpha = 0.0;
    double best_beta = 0.0;
    for (int k = 0; k < between.pass.count; ++k) {
        const double alpha = alphas[static_cast<std::size_t>(k)];
        const double beta = glm::dot(inwards, between.pass[k] - from);
        if (alpha * alpha + beta * beta < kTouching * kTouching) continue;
        if (alpha < kTouching) {
            if (beta > 0.0) return false;  // the plane of the source itself
            continue;                      // leans back as far as can be: parts nothing that another does not
        }
        if (is_found && beta * best_alpha <= best_beta * alpha) continue;
        is_found = true;
        best_alpha = alpha;
        best_beta = beta;
    }
    const double length = std::sqrt(best_alpha * best_alpha + best_beta * best_beta);
    if (!is_found || length < kUncertain) return false;
    plane.normal = (best_beta * between.source_plane.normal - best_alpha * inwards) / length;
    plane.offset = -glm::dot(plane.normal, from);
    return true;
}

/// Stops where `use` returns false, and returns that.
template <typename Use>
bool for_each_separator(const Separation& between, const Use& use)
{
    std::array<double, Winding::kMostCorners> alphas;  // NOLINT: filled below
    for (int k = 0; k < between.pass.count; ++k) {
        alphas[static_cast<std::size_t>(k)] = between.source_plane.distance(between.pass[k]);
    }
    for (int i = 0; i < between.source.count; ++i) {
        FlowPlane plane;
        if (!separator(between, alphas, i, plane)) continue;
        if (between.keeps_source_side) plane = {-plane.normal, -plane.offset};
        if (!use(plane)) return false;
    }
    return true;
}

}  // namespace

Winding::Winding(std::span<const glm::dvec3> corners)
{
    if (corners.size() > static_cast<std::size_t>(kMostCorners) / 2) {
        enclose(corners, *this);
        return;
    }
    for (const glm::dvec3& corner : corners) points[static_cast<std::size_t>(count++)] = corner;
}

bool clip(Winding& winding, const FlowPlane& plane, const ClipTolerance& tolerance)
{
    std::array<double, Winding::kMostCorners> distances;  // NOLINT: filled below
    double least = 0.0;
    double most = -1.0;
    for (int i = 0; i < winding.count; ++i) {
        const double distance = plane.distance(winding[i]);
        distances[static_cast<std::size_t>(i)] = distance + tolerance.slack;
        least = std::min(least, distance);
        most = std::max(most, distance);
    }
    if (most < tolerance.least) return false;
    if (least >= -tolerance.slack || winding.count + 1 > Winding::kMostCorners) return true;
    Winding result;
    std::size_t kept = 0;
    for (int i = 0; i < winding.count; ++i) {
        const int next = i + 1 == winding.count ? 0 : i + 1;
        const double a = distances[static_cast<std::size_t>(i)];
        const double b = distances[static_cast<std::size_t>(next)];
        // Of slivers whose corners are off a convex place by roundings a plane may cut more than two sides.
        if (kept + 2 > static_cast<std::size_t>(Winding::kMostCorners)) return true;
        if (a >= 0.0) result.points[kept++] = winding[i];
        if ((a < 0.0) != (b < 0.0)) result.points[kept++] = winding[i] + (winding[next] - winding[i]) * (a / (a - b));
    }
    result.count = static_cast<int>(kept);
    winding = result;
    return winding.count >= 3;
}

bool clip_to_separators(Winding& target, const Separation& between, const ClipTolerance& tolerance)
{
    return for_each_separator(between, [&](const FlowPlane& plane) { return clip(target, plane, tolerance); });
}

void add_separators(const Separation& between, std::vector<FlowPlane>& planes)
{
    for_each_separator(between, [&](const FlowPlane& plane) {
        planes.push_back(plane);
        return true;
    });
}

}  // namespace hw
