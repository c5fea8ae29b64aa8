#pragma once

#include <array>
#include <span>
#include <vector>

#include "hatchway/geometry/lines/face_tree.hpp"
#include "hatchway/geometry/lines/seams.hpp"

namespace hw {

/// A part of a segment, in lengths from its first end.
struct Interval {
    double from;
    double to;
};

/// One face that ends at a line, world space.
struct FaceAtSegment {
    glm::dvec3 apex;    ///< Its corner off the line.
    glm::dvec3 normal;  ///< Unit, to the side from which it is seen.
    bool is_two_sided;  ///< It is seen from the other side, too.
};

/// Finds where a line lies inside of a coplanar face of the same style, so that the surface goes on at both sides of
/// it: kit pieces that lie into one another.
class Overlaps {
 public:
    Overlaps(std::span<const SeamObject> objects, const SeamOptions& options);

    /// Appends the parts of the segment that such a face covers, while all faces at the line lie in its plane or
    /// behind, where it is not seen from there. How many triangles it looked at. Thread safe.
    std::uint64_t find(const glm::dvec3& from, const glm::dvec3& to, std::uint32_t style,
                       std::span<const FaceAtSegment> faces, std::vector<Interval>& parts) const;

 private:
    struct Triangle {
        std::array<glm::dvec3, 3> corners;
        glm::dvec3 normal;
        std::uint32_t style;
        bool is_double_sided;
    };
    struct Way {
        const glm::dvec3& from;
        const glm::dvec3& to;
        std::uint32_t style;
        std::size_t face_count;
    };
    std::vector<Interval> covered(const Way& way, const glm::dvec3& shift, const glm::dvec3& normal,
                                  std::uint64_t& looked_at) const;
    static std::vector<Triangle> triangles_of(std::span<const SeamObject> objects);
    static std::vector<Box> boxes_of(const std::vector<Triangle>& triangles);

    SeamOptions options_;
    std::vector<Triangle> triangles_;
    FaceTree tree_;
};

}  // namespace hw
