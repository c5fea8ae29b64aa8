#pragma once

#include <cmath>
#include <glm/vec3.hpp>

namespace hw {

/// An sRGB colour, as parameters hold it, in linear light, as shaders compute. Cheaper here, once, than for each
/// fragment.
inline glm::vec3 linear_colour(const glm::vec3& srgb)
{
    const auto linear = [](float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); };
    return {linear(srgb.r), linear(srgb.g), linear(srgb.b)};
}

}  // namespace hw
