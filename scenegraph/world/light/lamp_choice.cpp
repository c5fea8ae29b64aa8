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
}

LampChoice::Asked LampChoice::asked(std::uint32_t number, float share) const
{
    const double sought = (number + static_cast<double>(share)) / kMostAsked;
    auto found = std::upper_bound(power_so_far_.begin(), power_so_far_.end(), sought);
    if (found == power_so_far_.end()) --found;
    const double chance = *found - (found == power_so_far_.begin() ? 0.0 : *(found - 1));
    return {static_cast<std::uint32_t>(found - power_so_far_.begin()), static_cast<float>(1.0 / (kMostAsked * chance))};
}

}  // namespace hw
