#pragma once

#include <cmath>
#include <glm/geometric.hpp>

namespace hw {

/// What MeshData::normals holds of a stated normal: the unit one, or zero where it has no direction to speak of.
inline glm::vec3 unit_or_zero(const glm::vec3& v)
{
    constexpr float kShortest = 1e-6f;
    const float length = glm::length(v);
    return std::isfinite(length) && length > kShortest ? v / length : glm::vec3(0.0f);
}

}  // namespace hw
