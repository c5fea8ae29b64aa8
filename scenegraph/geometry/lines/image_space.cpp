#include "hatchway/geometry/lines/image_space.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "hatchway/geometry/picture_up.hpp"

namespace hw {
namespace {

void append_if_seen(const std::array<ImagePoint, 3>& corners, const ImageTriangle& whole,
                    std::vector<ImageTriangle>& triangles)
{
    if (side_of(corners[0], corners[1], corners[2].x, corners[2].y) == 0.0) return;
    triangles.push_back({corners, whole.face, whole.object});
}

}  // namespace

ImageSpace::ImageSpace(const LineCamera& camera)
    : origin_world_(camera.eye_world),
      viewpoint_{camera.eye_world, false},
      is_parallel_(camera.orthographic_height_m.has_value()),
      centre_(0.5 * glm::dvec2(camera.size_px)),
      focal_px_(is_parallel_ ? 2.0 * centre_.y / *camera.orthographic_height_m
                             : centre_.y / std::tan(0.5 * camera.fov_rad)),
      near_m_(camera.near_m)
{
    const glm::dvec3 forward = glm::normalize(camera.target_world - camera.eye_world);
    if (is_parallel_) {
        viewpoint_ = {camera.eye_world - camera.target_world, true};
        origin_world_ += camera.near_m * forward;
        depth_m_ = camera.far_m - camera.near_m;
        near_m_ = 0.0;
    }
    const glm::dvec3 up = picture_up(forward, camera.roll_rad);
    const glm::dvec3 right = glm::cross(forward, up);
    for (int axis = 0; axis < 3; ++axis) {
        view_from_world_[axis] = glm::dvec4(right[axis], up[axis], forward[axis], 0.0);
    }
    view_from_world_[3] = glm::dvec4(-glm::dot(right, origin_world_), -glm::dot(up, origin_world_),
                                     -glm::dot(forward, origin_world_), 1.0);
}

std::optional<ImageSpace::Clipped> ImageSpace::clipped(const glm::dvec3& from, const glm::dvec3& to) const
{
    Clipped result{from, to};
    if (from.z < near_m_ && to.z < near_m_) return std::nullopt;
    if (from.z >= near_m_ && to.z >= near_m_) return result;
    const glm::dvec3 cut = glm::mix(from, to, (near_m_ - from.z) / (to.z - from.z));
    (from.z < near_m_ ? result.from : result.to) = glm::dvec3(cut.x, cut.y, near_m_);
    (from.z < near_m_ ? result.is_from_clipped : result.is_to_clipped) = true;
    return result;
}

std::optional<ImageLine> part_in_picture(const ImageSpace& space, const glm::dvec3& from_view,
                                         const glm::dvec3& to_view)
{
    const auto part = space.clipped(from_view, to_view);
    if (!part) return std::nullopt;
    const ImagePoint from = space.project(part->from), to = space.project(part->to);
    const glm::dvec2 size = space.size_px();
    const ImagePoint direction = to - from;
    double begin = 0.0, end = 1.0;
    for (int axis = 0; axis < 2; ++axis) {
        const double at = from[axis], step = direction[axis];
        if (step == 0.0) {
            if (at < 0.0 || at > size[axis]) return std::nullopt;
            continue;
        }
        const double enter = (step > 0.0 ? -at : size[axis] - at) / step;
        const double leave = (step > 0.0 ? size[axis] - at : -at) / step;
        begin = std::max(begin, enter);
        end = std::min(end, leave);
    }
    const ImageLine seen{begin > 0.0 ? from + begin * direction : from, end < 1.0 ? from + end * direction : to,
                         !part->is_from_clipped && begin == 0.0, !part->is_to_clipped && end == 1.0};
    if (begin >= end || glm::dvec2(seen.from) == glm::dvec2(seen.to)) return std::nullopt;
    return seen;
}

std::optional<std::array<glm::dvec3, 2>> near_cut(const ImageSpace& space,
                                                  const std::array<glm::dvec3, 3>& corners_view)
{
    std::array<glm::dvec3, 2> ends;
    std::size_t count = 0;
    for (int i = 0; i < 3; ++i) {
        const auto part = space.clipped(corners_view[i], corners_view[(i + 1) % 3]);
        if (part && part->is_from_clipped != part->is_to_clipped)
            ends[count++] = part->is_from_clipped ? part->from : part->to;
    }
    if (count < ends.size()) return std::nullopt;
    return ends;
}

void append_triangles(const ImageSpace& space, const std::array<glm::dvec3, 3>& corners_view,
                      const ImageTriangle& whole, std::vector<ImageTriangle>& triangles)
{
    std::array<ImagePoint, 4> polygon;
    int count = 0;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3& from = corners_view[i];
        const glm::dvec3& to = corners_view[(i + 1) % 3];
        if (from.z >= space.near_m()) polygon[count++] = space.project(from);
        if ((from.z >= space.near_m()) == (to.z >= space.near_m())) continue;
        const auto part = space.clipped(from, to);
        polygon[count++] = space.project(part->is_from_clipped ? part->from : part->to);
    }
    if (count < 3) return;
    append_if_seen({polygon[0], polygon[1], polygon[2]}, whole, triangles);
    if (count == 4) append_if_seen({polygon[0], polygon[2], polygon[3]}, whole, triangles);
}

}  // namespace hw
