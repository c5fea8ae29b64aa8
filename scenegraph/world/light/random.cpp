#include "hatchway/world/light/random.hpp"

#include <glm/gtc/constants.hpp>

namespace hw {
namespace {

std::uint32_t reversed_bits(std::uint32_t x)
{
    x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
    return (x >> 16) | (x << 16);
}

/// Every bit is flipped or not by a hash of the bits above it, which keeps the points of a net apart.
std::uint32_t nested_scramble(std::uint32_t x, std::uint32_t seed)
{
    x = reversed_bits(x);
    x += seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return reversed_bits(x);
}

/// The second coordinate of Sobol's sequence; the first is the reversed index.
std::uint32_t sobol_second(std::uint32_t index)
{
    std::uint32_t result = 0;
    for (std::uint32_t column = 0x80000000u; index != 0; index >>= 1, column ^= column >> 1)
        if (index & 1u) result ^= column;
    return result;
}

float unit_float(std::uint32_t x)
{
    return static_cast<float>(x >> 8) * 0x1p-24f;
}

/// Two unit vectors across a unit vector. Source: Duff et al. Building an Orthonormal Basis, Revisited. JCGT 6(1),
/// 2017.
void basis_of(const glm::vec3& n, glm::vec3& u, glm::vec3& v)
{
    const float sign = std::copysign(1.0f, n.z);
    const float a = -1.0f / (sign + n.z);
    const float b = n.x * n.y * a;
    u = {1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x};
    v = {b, sign + n.y * n.y * a, -n.y};
}

}  // namespace

glm::vec2 sample_2d(std::uint32_t index, std::uint32_t dimension, std::uint32_t seed)
{
    const std::uint32_t own = mixed(seed ^ mixed(dimension * 0x9e3779b9u + 0x85ebca6bu));
    const std::uint32_t shuffled = nested_scramble(index, own);
    const std::uint32_t x = nested_scramble(reversed_bits(shuffled), mixed(own + 1));
    const std::uint32_t y = nested_scramble(sobol_second(shuffled), mixed(own + 2));
    return {unit_float(x), unit_float(y)};
}

glm::vec3 disc_point(const glm::vec3& axis, const glm::vec2& sample)
{
    glm::vec3 u, v;
    basis_of(axis, u, v);
    const float radius = std::sqrt(sample.x);
    const float angle = 2.0f * glm::pi<float>() * sample.y;
    return radius * (std::cos(angle) * u + std::sin(angle) * v);
}

glm::vec3 cosine_direction(const glm::vec3& normal, const glm::vec2& sample)
{
    return disc_point(normal, sample) + std::sqrt(std::max(0.0f, 1.0f - sample.x)) * normal;
}

}  // namespace hw
