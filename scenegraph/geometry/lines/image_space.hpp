#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "hatchway/geometry/exact/viewpoint.hpp"
#include "hatchway/geometry/lines/visible_lines.hpp"

namespace hw {

/// The space in which hidden lines are removed: x and y in pixels, z = 1 / depth, larger is nearer; of a parallel
/// projection z falls from 2 at the near plane to 1 at the far one. Lines and planes of the world are lines and planes
/// here.
using ImagePoint = glm::dvec3;

/// A camera as a map into image space.
class ImageSpace {
 public:
    explicit ImageSpace(const LineCamera& camera);

    bool is_parallel() const { return is_parallel_; }
    /// The eye as facing is decided by it.
    Viewpoint viewpoint() const { return viewpoint_; }
    /// Right, up, depth from the origin; metres.
    glm::dmat4 view_from_world() const { return view_from_world_; }
    /// The eye; of a parallel projection the point of its axis at the near plane.
    glm::dvec3 origin_world() const { return origin_world_; }
    ImagePoint project(const glm::dvec3& view) const
    {
        if (is_parallel_)
            return {centre_.x + focal_px_ * view.x, centre_.y - focal_px_ * view.y, 2.0 - view.z / depth_m_};
        const double inverse = 1.0 / view.z;
        return {centre_.x + focal_px_ * view.x * inverse, centre_.y - focal_px_ * view.y * inverse, inverse};
    }
    /// What is seen at a point of the picture: the inverse of project().
    glm::dvec3 view_of(const ImagePoint& point) const
    {
        const double depth = is_parallel_ ? (2.0 - point.z) * depth_m_ : 1.0 / point.z;
        const double m_per_px = (is_parallel_ ? 1.0 : depth) / focal_px_;
        return {(point.x - centre_.x) * m_per_px, (centre_.y - point.y) * m_per_px, depth};
    }
    /// The place in the world of a point of the picture.
    glm::dvec3 world_of(const ImagePoint& point) const
    {
        return origin_world_ + glm::transpose(glm::dmat3(view_from_world_)) * view_of(point);
    }
    /// Along the view from the origin.
    double near_m() const { return near_m_; }
    glm::dvec2 size_px() const { return 2.0 * centre_; }
    /// Pixels of a metre at a depth of one metre; of a parallel projection at every depth.
    double focal_px() const { return focal_px_; }
    double px_per_m(const ImagePoint& point) const { return is_parallel_ ? focal_px_ : focal_px_ * point.z; }
    /// Half of what the picture shows at this depth, metres.
    glm::dvec2 half_m(double depth) const { return (is_parallel_ ? 1.0 : depth) / focal_px_ * centre_; }
    /// What a place in the picture is known relative to, pixels.
    double reach_px() const { return focal_px_ * (is_parallel_ ? depth_m_ : 1.0) + 2.0 * (centre_.x + centre_.y); }

    /// The part of a view-space segment before the near plane, or nothing.
    struct Clipped {
        glm::dvec3 from;
        glm::dvec3 to;
        bool is_from_clipped = false;
        bool is_to_clipped = false;
    };
    std::optional<Clipped> clipped(const glm::dvec3& from, const glm::dvec3& to) const;

 private:
    glm::dmat4 view_from_world_{1.0};
    glm::dvec3 origin_world_{0.0};
    Viewpoint viewpoint_;
    bool is_parallel_ = false;
    double depth_m_ = 1.0;  ///< Of a parallel projection, from the near plane to the far one.
    glm::dvec2 centre_{0.0};
    double focal_px_ = 1.0;
    double near_m_ = 0.01;
};

/// What the picture shows of a straight line.
struct ImageLine {
    ImagePoint from{0.0};
    ImagePoint to{0.0};
    bool is_from_whole = true;  ///< `from` is the line's own end, not where it was cut off.
    bool is_to_whole = true;
};

/// Cuts a line at the near plane and at the picture's frame; nothing when no length of it is left.
std::optional<ImageLine> part_in_picture(const ImageSpace& space, const glm::dvec3& from_view,
                                         const glm::dvec3& to_view);

/// Where the near plane cuts a triangle, view space; nothing where it does not.
std::optional<std::array<glm::dvec3, 2>> near_cut(const ImageSpace& space,
                                                  const std::array<glm::dvec3, 3>& corners_view);

/// A face in image space that can hide lines.
struct ImageTriangle {
    std::array<ImagePoint, 3> corners;
    std::uint32_t face = 0;    ///< Its number among all faces of all objects.
    std::uint32_t object = 0;  ///< Index into the objects given.
};

/// Twice the signed area of the picture of a, b, p. Exactly opposite for b, a: neighbours leave no gap between them.
inline double side_of(const ImagePoint& a, const ImagePoint& b, double x, double y)
{
    const bool is_in_order = a.x < b.x || (a.x == b.x && a.y < b.y);
    const ImagePoint& u = is_in_order ? a : b;
    const ImagePoint& v = is_in_order ? b : a;
    const double area = (v.x - u.x) * (y - u.y) - (v.y - u.y) * (x - u.x);
    return is_in_order ? area : -area;
}

/// Appends the picture of a triangle, cut by the near plane into up to two; nothing when it is behind or edge-on.
/// `whole` tells its face and object.
void append_triangles(const ImageSpace& space, const std::array<glm::dvec3, 3>& corners_view,
                      const ImageTriangle& whole, std::vector<ImageTriangle>& triangles);

}  // namespace hw
