#include "hatchway/geometry/lines/overlaps.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

namespace hw {
namespace {

constexpr std::size_t kMostTriangles = 4'000'000;  // of all objects; past that all lines stay
constexpr std::uint64_t kMostOfLine = 10'000'000;  // triangles and pairs of faces looked at; the rest of it stays
constexpr double kBeyond = 4.0;                    // in tolerances: how far beyond the line the surface is looked for

/// The part of the way a..b, in [0, 1], that is inside of a triangle in one plane with it.
std::optional<Interval> part_inside(const glm::dvec3& a, const glm::dvec3& b, const std::array<glm::dvec3, 3>& corners,
                                    const glm::dvec3& normal)
{
    Interval part{0.0, 1.0};
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 inward = glm::cross(normal, corners[(i + 1) % 3] - corners[i]);
        const double begin = glm::dot(inward, a - corners[i]), end = glm::dot(inward, b - corners[i]);
        if (begin < 0.0 && end < 0.0) return std::nullopt;
        if (begin >= 0.0 && end >= 0.0) continue;
        const double cut = begin / (begin - end);
        (begin < 0.0 ? part.from : part.to) = begin < 0.0 ? std::max(part.from, cut) : std::min(part.to, cut);
    }
    return part.from < part.to ? std::optional(part) : std::nullopt;
}

std::vector<Interval> united(std::vector<Interval> parts)
{
    constexpr double kTouching = 1e-9;
    std::sort(parts.begin(), parts.end(), [](const Interval& a, const Interval& b) { return a.from < b.from; });
    std::vector<Interval> whole;
    for (const Interval& part : parts) {
        if (!whole.empty() && part.from <= whole.back().to + kTouching)
            whole.back().to = std::max(whole.back().to, part.to);
        else
            whole.push_back(part);
    }
    return whole;
}

}  // namespace

Overlaps::Overlaps(std::span<const SeamObject> objects, const SeamOptions& options)
    : options_(options), triangles_(triangles_of(objects)), tree_(boxes_of(triangles_))
{
}

std::vector<Overlaps::Triangle> Overlaps::triangles_of(std::span<const SeamObject> objects)
{
    std::vector<Triangle> triangles;
    std::size_t count = 0;
    for (const SeamObject& object : objects) count += object.surface->faces.size();
    if (count > kMostTriangles) return triangles;
    triangles.reserve(count);
    for (const SeamObject& object : objects) {
        const double side = glm::determinant(glm::dmat3(object.world_from_object)) < 0.0 ? -1.0 : 1.0;
        const Surface& surface = *object.surface;
        for (std::uint32_t id = 0; id < surface.faces.size(); ++id) {
            const auto& face = surface.faces[id];
            if (surface.face_triangle[id] == kNoFace) continue;
            Triangle triangle{{}, {}, object.style, object.is_double_sided || surface.is_two_sided(id)};
            for (int i = 0; i < 3; ++i)
                triangle.corners[i] =
                    glm::dvec3(object.world_from_object * glm::dvec4(glm::dvec3(surface.positions[face[i]]), 1.0));
            if (side < 0.0) std::swap(triangle.corners[1], triangle.corners[2]);
            const glm::dvec3 area =
                glm::cross(triangle.corners[1] - triangle.corners[0], triangle.corners[2] - triangle.corners[0]);
            const double size = glm::length(area);
            if (!(size > 0.0)) continue;
            triangle.normal = area / size;
            triangles.push_back(triangle);
        }
    }
    return triangles;
}

std::vector<Box> Overlaps::boxes_of(const std::vector<Triangle>& triangles)
{
    std::vector<Box> boxes(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (const glm::dvec3& corner : triangles[i].corners) boxes[i].add(corner);
    return boxes;
}

/// Where the surface of `style` lies along a..b in a plane that looks to `normal`; without the faces of the line
/// itself.
std::vector<Interval> Overlaps::covered(const Way& way, const glm::dvec3& shift, const glm::dvec3& normal,
                                        std::uint64_t& looked_at) const
{
    const double tolerance = options_.tolerance_m;
    const glm::dvec3 a = way.from + shift, b = way.to + shift;
    Box box;
    for (const glm::dvec3& end : {a, b}) {
        box.add(end - glm::dvec3(tolerance));
        box.add(end + glm::dvec3(tolerance));
    }
    std::vector<std::uint32_t> found;
    looked_at += tree_.find(box, found);
    std::vector<Interval> parts;
    for (const std::uint32_t id : found) {
        const Triangle& triangle = triangles_[id];
        const double facing = glm::dot(triangle.normal, normal);
        // The back of a sheet goes on the front of another only where neither is part of a solid.
        const bool is_sheet = triangle.is_double_sided && way.face_count == 1;
        const bool is_same_side = (is_sheet ? std::abs(facing) : facing) > std::cos(options_.flat_rad);
        const auto has_corner = [&](const glm::dvec3& p) {
            return std::find(triangle.corners.begin(), triangle.corners.end(), p) != triangle.corners.end();
        };
        if (triangle.style != way.style || !is_same_side || (has_corner(way.from) && has_corner(way.to))) continue;
        const auto off_plane = [&](const glm::dvec3& p) {
            return std::abs(glm::dot(triangle.normal, p - triangle.corners[0]));
        };
        if (std::max(off_plane(a), off_plane(b)) > tolerance) continue;
        if (const auto part = part_inside(a, b, triangle.corners, triangle.normal)) parts.push_back(*part);
    }
    return united(std::move(parts));
}

std::uint64_t Overlaps::find(const glm::dvec3& from, const glm::dvec3& to, std::uint32_t style,
                             std::span<const FaceAtSegment> faces, std::vector<Interval>& parts) const
{
    const double tolerance = options_.tolerance_m, length = glm::distance(from, to);
    std::uint64_t looked_at = 0;
    if (length <= kBeyond * tolerance) return looked_at;
    const glm::dvec3 along = (to - from) / length;
    for (const FaceAtSegment& face : faces) {
        looked_at += faces.size();
        if (looked_at > kMostOfLine) break;
        const bool is_outermost = std::all_of(faces.begin(), faces.end(), [&](const FaceAtSegment& other) {
            const double before = glm::dot(face.normal, other.apex - from);
            return before <= tolerance && (!face.is_two_sided || before >= -tolerance);
        });
        if (!is_outermost) continue;
        glm::dvec3 inward = face.apex - from;
        inward = kBeyond * tolerance * glm::normalize(inward - glm::dot(inward, along) * along);
        const Way way{from, to, style, faces.size()};
        const std::vector<Interval> beyond = covered(way, -inward, face.normal, looked_at);
        if (beyond.empty()) continue;
        const std::vector<Interval> within = covered(way, inward, face.normal, looked_at);
        for (const Interval& outer : beyond)
            for (const Interval& inner : within) {
                const Interval both{std::max(outer.from, inner.from), std::min(outer.to, inner.to)};
                if (both.from < both.to) parts.push_back({both.from * length, both.to * length});
            }
    }
    return looked_at;
}

}  // namespace hw
