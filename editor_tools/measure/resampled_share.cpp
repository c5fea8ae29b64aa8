#include "measure/resampled_share.hpp"

#include <algorithm>
#include <random>
#include <vector>

#include "measure/no_value.hpp"

namespace hw::measure {
namespace {

constexpr std::size_t kDraws = 2000;

}  // namespace

ShareRange resampled_share(std::span<const std::pair<double, double>> parts)
{
    std::mt19937 random(1);
    std::vector<double> quotients;
    for (std::size_t draw = 0; draw < kDraws; ++draw) {
        double above = 0.0, below = 0.0;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const auto& [numerator, denominator] = parts[random() % parts.size()];
            above += numerator;
            below += denominator;
        }
        if (below > 0.0) quotients.push_back(above / below);
    }
    if (quotients.empty()) return {kNoValue, kNoValue};
    std::sort(quotients.begin(), quotients.end());
    return {quotients[quotients.size() / 40], quotients[quotients.size() - 1 - quotients.size() / 40]};
}

}  // namespace hw::measure
