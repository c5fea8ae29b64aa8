#include "hatchway/drawing/stroke_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>

namespace hw {
namespace {

float hash(std::int32_t x, std::int32_t y, std::int32_t z, std::int32_t w)
{
    std::uint32_t h = static_cast<std::uint32_t>(x) * 747796405u + static_cast<std::uint32_t>(y) * 2891336453u +
                      static_cast<std::uint32_t>(z) * 1181783497u + static_cast<std::uint32_t>(w) * 374761393u;
    h ^= h >> 16;
    h *= 2246822519u;
    h ^= h >> 13;
    h *= 3266489917u;
    h ^= h >> 16;
    return static_cast<float>(h & 0xffffffu) / 8388607.5f - 1.0f;
}

float ease(float f)
{
    return f * f * (3.0f - 2.0f * f);
}

float noise(float at, float seed)
{
    const float cell = std::floor(at);
    const auto x = static_cast<std::int32_t>(cell);
    const auto own = static_cast<std::int32_t>(std::floor(seed * 65536.0f));
    return glm::mix(hash(x, own, 0, 0), hash(x + 1, own, 0, 0), ease(at - cell));
}

float noise(const glm::vec3& at, int seed)
{
    const glm::vec3 cell = glm::floor(at);
    const glm::ivec3 first(cell);
    float sum = 0.0f;
    for (int i = 0; i < 8; ++i) {
        const glm::ivec3 corner(i & 1, (i >> 1) & 1, i >> 2);
        float share = 1.0f;
        for (int axis = 0; axis < 3; ++axis) {
            const float f = ease(at[axis] - cell[axis]);
            share *= corner[axis] == 1 ? f : 1.0f - f;
        }
        sum += share * hash(first.x + corner.x, first.y + corner.y, first.z + corner.z, seed);
    }
    return 1.5f * sum;
}

/// Bends are taken from the two nearest lengths in powers of two: scales on the object and the share of the second.
struct Octave {
    float fine = 1.0f;
    float share = 0.0f;

    Octave(float bend_px, float px_per_unit)
    {
        const float octave = std::log2(std::max(bend_px, 1.0f) / std::max(px_per_unit, 1e-20f));
        fine = std::exp2(-std::floor(octave));
        share = octave - std::floor(octave);
    }
};

}  // namespace

double StrokeShape::step_px() const
{
    const double taper = character_.taper_px > 0.0f ? character_.taper_px : 1e9;
    return std::clamp(std::min(static_cast<double>(character_.bend_px), taper) / 8.0, 1.0, 8.0);
}

double StrokeShape::stray(float arc, float seed, float px_per_unit) const
{
    const Octave octave(character_.bend_px, px_per_unit);
    return character_.wobble_px *
           glm::mix(noise(arc * octave.fine, seed), noise(arc * 0.5f * octave.fine, seed), octave.share);
}

glm::dvec2 StrokeShape::silhouette_stray(const glm::vec3& place, float px_per_unit) const
{
    const Octave octave(character_.bend_px, px_per_unit);
    glm::dvec2 stray(0.0);
    for (int axis = 0; axis < 2; ++axis)
        stray[axis] = character_.wobble_px *
                      glm::mix(noise(place * octave.fine, axis), noise(place * 0.5f * octave.fine, axis), octave.share);
    return stray;
}

double StrokeShape::taper(const LineStroke& stroke, float arc, float px_per_unit) const
{
    if (character_.taper_px <= 0.0f || stroke.length <= 0.0f) return 1.0;
    const double end_px = std::max(std::min(arc, stroke.length - arc), 0.0f) * px_per_unit;
    const double t = std::clamp(end_px / character_.taper_px, 0.0, 1.0);
    return glm::mix(0.3, 1.0, t * t * (3.0 - 2.0 * t));
}

double StrokeShape::overshoot_px(const LineStroke& stroke, int end) const
{
    const float arc = end == 0 ? stroke.from : stroke.to;
    const bool is_end = stroke.length > 0.0f && std::min(arc, stroke.length - arc) < 1e-5f * stroke.length;
    if (!is_end) return 0.0;
    // Some ends run on farther than others.
    const float number = stroke.seed * (end == 0 ? 3.17f : 7.31f) + arc * 1.618f;
    return character_.overshoot_px * (0.4f + 0.6f * (number - std::floor(number)));
}

float StrokeShape::dash_period(float px_per_unit) const
{
    return std::exp2(std::floor(std::log2(character_.dash_px / std::max(px_per_unit, 1e-20f)) + 0.5f));
}

float StrokeShape::dash_phase(float arc, float seed, float period) const
{
    const float at = arc / period + seed;
    return at - std::floor(at);
}

}  // namespace hw
