#include "hatchway/render/view/mirror_view.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace hw {
namespace {

/// The part of a polygon in clip space where `plane` is not negative.
std::vector<glm::dvec4> cut(const std::vector<glm::dvec4>& polygon, const glm::dvec4& plane)
{
    std::vector<glm::dvec4> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec4 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double at_a = glm::dot(plane, a), at_b = glm::dot(plane, b);
        if (at_a >= 0.0) kept.push_back(a);
        if ((at_a >= 0.0) != (at_b >= 0.0)) kept.push_back(glm::mix(a, b, at_a / (at_a - at_b)));
    }
    return kept;
}

/// How far the box reaches in front of the plane.
double reach(const Box& box, const MirrorPlane& plane)
{
    return plane.height(box.centre()) + 0.5 * glm::dot(glm::abs(plane.normal_world), box.size());
}

/// The largest depth before the mirror's plane, as a share of the distance along the view, that the window shows: it is
/// at a corner, infinitely far away.
double steepest(const glm::dmat4& clip_from_view, const glm::dvec3& normal_view, const PictureWindow& window)
{
    double largest = 0.0;
    for (const double x : {window.min.x, window.max.x})
        for (const double y : {window.min.y, window.max.y}) {
            const glm::dvec3 way(x / clip_from_view[0][0], y / clip_from_view[1][1], -1.0);
            largest = std::max(largest, glm::dot(normal_view, way));
        }
    return largest;
}

}  // namespace

std::optional<PictureWindow> window_of(std::span<const glm::dvec3> outline_world, const View& view,
                                       const PictureWindow& window)
{
    constexpr double kLeastW = 1e-9;
    constexpr glm::dvec4 kNear(0.0, 0.0, 1.0, 1.0);
    const glm::dmat4 clip_from_relative =
        glm::dmat4(view.clip_from_view) * glm::dmat4(glm::dmat3(glm::dmat4(view.view_from_world)));
    std::vector<glm::dvec4> polygon;
    for (const glm::dvec3& corner : outline_world)
        polygon.push_back(clip_from_relative * glm::dvec4(corner - view.eye_world, 1.0));
    const std::vector<glm::dvec4> sides{kNear,
                                        {1.0, 0.0, 0.0, -window.min.x},
                                        {-1.0, 0.0, 0.0, window.max.x},
                                        {0.0, 1.0, 0.0, -window.min.y},
                                        {0.0, -1.0, 0.0, window.max.y}};
    for (const glm::dvec4& side : sides) polygon = cut(polygon, side);
    PictureWindow found{glm::dvec2(INFINITY), glm::dvec2(-INFINITY)};
    for (const glm::dvec4& corner : polygon) {
        if (corner.w < kLeastW) continue;  // the eye itself
        found.min = glm::min(found.min, glm::dvec2(corner) / corner.w);
        found.max = glm::max(found.max, glm::dvec2(corner) / corner.w);
    }
    if (!(found.min.x < found.max.x && found.min.y < found.max.y)) return {};
    return PictureWindow{glm::max(found.min, window.min), glm::min(found.max, window.max)};
}

PictureWindow with_room(const PictureWindow& window, const View& view)
{
    constexpr double kRoomPx = 32.0;
    const glm::dvec2 room = 2.0 * kRoomPx * view.px_scale / glm::dvec2(view.size_px);
    return {glm::max(window.min - room, -1.0), glm::min(window.max + room, 1.0)};
}

View reflected_view(const View& view, const MirrorPlane& plane, const PictureWindow& window, const Box& scene_bounds)
{
    const glm::dvec3& normal = plane.normal_world;
    const glm::dmat4 reflection(glm::dmat3(1.0) - 2.0 * glm::outerProduct(normal, normal));
    const glm::dmat4 rotation = glm::dmat4(glm::dmat3(glm::dmat4(view.view_from_world))) * reflection;
    View mirrored = view;
    mirrored.is_mirrored = !view.is_mirrored;
    mirrored.eye_world = plane.reflected(view.eye_world);
    mirrored.to_viewer_world = glm::dvec3(reflection * glm::dvec4(view.to_viewer_world, 0.0));
    glm::dmat4 view_from_world = rotation;
    view_from_world[3] = rotation * glm::dvec4(-mirrored.eye_world, 1.0);
    mirrored.view_from_world = glm::mat4(view_from_world);
    // In front of the mirror is where dot(front, position in the view) is positive.
    const glm::dvec3 normal_view(rotation * glm::dvec4(normal, 0.0));
    const glm::dvec4 front(normal_view, plane.height(mirrored.eye_world));
    const double deepest = view.is_orthographic() ? reach(scene_bounds, plane)
                                                  : steepest(glm::dmat4(view.clip_from_view), normal_view, window);
    const double scale = 2.0 / std::max(deepest, 1e-12);
    for (int i = 0; i < 4; ++i)
        mirrored.clip_from_view[i][2] = static_cast<float>(scale * front[i] - view.clip_from_view[i][3]);
    return mirrored;
}

}  // namespace hw
