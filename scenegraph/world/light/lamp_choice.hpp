#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hatchway/world/scene.hpp"

namespace hw {

/// Of suns, points and spots those that a place asks for light: all, or of many a few chosen by power, so that light
/// costs the same however many shine.
class LampChoice {
 public:
    static constexpr std::uint32_t kMostAsked = 64;

    /// `reach_m`: how far from a lamp a place is, about; suns are compared with lamps by it.
    LampChoice() = default;
    LampChoice(std::span<const Light> lights, double reach_m);

    struct Asked {
        std::uint32_t light = 0;
        float stands_for = 1.0f;  ///< So many such lights, itself included: what it gives counts so often.
    };
    bool asks_all() const { return power_so_far_.empty(); }
    /// The lamp `number` below kMostAsked of those that are asked where not all are. `share` in [0, 1): lamps that all
    /// numbers get over all shares, each counted as often as it stands for, are all lamps.
    Asked asked(std::uint32_t number, float share) const;

 private:
    std::vector<double> power_so_far_;  ///< Of the lights up to each, as a share of all; empty: all are asked.
    /// The light that a search begins with, for each of as many equal slices of the power as there are lights. Source:
    /// Chen, Asmus. On Generating Random Variates from an Empirical Distribution. AIIE Transactions 6 (1974).
    std::vector<std::uint32_t> first_of_slice_;
};

}  // namespace hw
