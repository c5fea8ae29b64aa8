#include "hatchway/world/light/lamp_choice.hpp"

#include <algorithm>

#include "hatchway/world/light/material.hpp"

namespace hw {

LampChoice::LampChoice(std::span<const Light> lights, double reach_m)
{
    if (lights.size() <= kMostAsked) return;
    double total = 0.0;
    for (const Light& light : lights) {
        const double power = luminance_of(light.colour * light.intensity);
        power_so_far_.push_back(total += light.type == LightType::sun ? power * reach_m * reach_m : power);
    }
    // A weak lamp may be the only one that a place sees: half of the choices look at no power.
    const auto count = static_cast<double>(lights.size());
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const double even = static_cast<double>(i + 1) / count;
        power_so_far_[i] = total > 0.0 ? 0.5 * power_so_far_[i] / total + 0.5 * even : even;
    }
    power_so_far_.back() = 1.0;
    for (std::size_t slice = 0, light = 0; slice < lights.size(); ++slice) {
        while (power_so_far_[light] <= static_cast<double>(slice) / count) ++light;
        first_of_slice_.push_back(static_cast<std::uint32_t>(light));
    }
}

LampChoice::Asked LampChoice::asked(std::uint32_t number, float share) const
{
    const double sought = (number + static_cast<double>(share)) / kMostAsked;
    const auto count = static_cast<std::uint32_t>(power_so_far_.size());
    const auto slice = static_cast<std::uint32_t>(sought * count);
    std::uint32_t light = first_of_slice_[std::min(slice, count - 1)];
    while (light + 1 < count && power_so_far_[light] <= sought) ++light;
    const double chance = power_so_far_[light] - (light == 0 ? 0.0 : power_so_far_[light - 1]);
    return {light, static_cast<float>(1.0 / (kMostAsked * chance))};
}

}  // namespace hw
