#pragma once

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace hw {

/// An axis-parallel box. A fresh one is empty: it contains nothing and grows from nothing.
struct Box {
    glm::dvec3 min{std::numeric_limits<double>::infinity()};
    glm::dvec3 max{-std::numeric_limits<double>::infinity()};

    bool is_empty() const { return min.x > max.x || min.y > max.y || min.z > max.z; }
    glm::dvec3 centre() const { return 0.5 * (min + max); }
    glm::dvec3 size() const { return max - min; }
    void add(const glm::dvec3& point)
    {
        min = glm::min(min, point);
        max = glm::max(max, point);
    }
    void add(const Box& other)
    {
        min = glm::min(min, other.min);
        max = glm::max(max, other.max);
    }
    bool overlaps(const Box& other) const
    {
        return min.x <= other.max.x && max.x >= other.min.x && min.y <= other.max.y && max.y >= other.min.y &&
               min.z <= other.max.z && max.z >= other.min.z;
    }
};

/// The box around the eight transformed corners of `box`; empty stays empty.
inline Box transformed(const Box& box, const glm::dmat4& matrix)
{
    Box result;
    if (box.is_empty()) return result;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p((corner & 1) ? box.max.x : box.min.x, (corner & 2) ? box.max.y : box.min.y,
                           (corner & 4) ? box.max.z : box.min.z);
        result.add(glm::dvec3(matrix * glm::dvec4(p, 1.0)));
    }
    return result;
}

}  // namespace hw
