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

#include "hatchway/geometry/lines/visible_lines.hpp"

namespace hw {

/// The space in which hidden lines are removed: x and y in pixels, z = 1 / depth, larger is nearer. Lines and planes of
/// the world are lines and planes here.
using ImagePoint = glm::dvec3;

/// A camera as a map into image space.
class ImageSpace {
 public:
    explicit ImageSpace(const LineCamera& camera);

    /// Right, up, depth from the eye; metres.
    glm::dmat4 view_from_world() const { return view_from_world_; }
    ImagePoint project(const glm::dvec3& view) const
    {
        const double inverse = 1.0 / view.z;
        return {centre_.x + focal_px_ * view.x * inverse, centre_.y - focal_px_ * view.y * inverse, inverse};
    }
    /// The place in the world of a point of the picture.
    glm::dvec3 world_of(const ImagePoint& point) const
    {
        const double depth = 1.0 / point.z;
        const glm::dvec3 view((point.x - centre_.x) * depth / focal_px_, (centre_.y - point.y) * depth / focal_px_,
                              depth);
        return eye_world_ + glm::transpose(glm::dmat3(view_from_world_)) * view;
    }
    double near_m() const { return near_m_; }
    glm::dvec2 size_px() const { return 2.0 * centre_; }
    double focal_px() const { return focal_px_; }

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
    glm::dvec3 eye_world_{0.0};
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
