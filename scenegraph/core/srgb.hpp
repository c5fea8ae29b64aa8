#pragma once

#include <cmath>

namespace hw {

/// Linear light of an sRGB value; both in [0, 1].
inline float linear_from_srgb(float value)
{
    return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

}  // namespace hw
