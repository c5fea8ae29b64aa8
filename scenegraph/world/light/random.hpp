#pragma once

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace hw {

/// A well mixed number from a number: seeds from indices.
inline std::uint32_t mixed(std::uint32_t x)
{
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

/// Point `index` of the sequence `dimension` of the stream `seed`, in [0, 1)^2. The first 2^k points of a sequence fall
/// one each into all cells of every grid of 2^k equal cells with sides of powers of two; sequences are independent.
/// Depends on the arguments alone. Source: Burley. Practical Hash-based Owen Scrambling. JCGT 9(4), 2020.
glm::vec2 sample_2d(std::uint32_t index, std::uint32_t dimension, std::uint32_t seed);

/// A direction around the unit vector `normal`, denser towards it by the cosine: density = cosine / pi.
glm::vec3 cosine_direction(const glm::vec3& normal, const glm::vec2& sample);

/// A point of the unit disc across the unit vector `axis`, evenly.
glm::vec3 disc_point(const glm::vec3& axis, const glm::vec2& sample);

}  // namespace hw
