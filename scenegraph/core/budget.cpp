#include "hatchway/core/budget.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hatchway/core/error.hpp"
#include "hatchway/core/limits.hpp"

namespace hw {
namespace {

struct Limit {
    const char* name;
    std::uint64_t most;
};

constexpr std::array<Limit, kCostCount> kLimits{{{"nodes", limits::kMaxNodes},
                                                 {"objects", limits::kMaxObjects},
                                                 {"triangles", limits::kMaxTriangles},
                                                 {"vertices", limits::kMaxVertices},
                                                 {"drawn triangles", limits::kMaxDrawnTriangles},
                                                 {"bytes of node paths", limits::kMaxPathBytes},
                                                 {"texels of maps", limits::kMaxMapPixels},
                                                 {"steps of rules", limits::kMaxRuleSteps},
                                                 {"bytes of a line drawing", limits::kMaxLineBytes},
                                                 {"steps of hidden lines", limits::kMaxLineSteps},
                                                 {"strokes", limits::kMaxStrokes},
                                                 {"layers of faces and lines", limits::kMaxLayers}}};

std::uint64_t most(Cost cost)
{
    constexpr double kMost = 1e18;  // fits an integer
    const double limit = Budget::factor() * static_cast<double>(kLimits[static_cast<std::size_t>(cost)].most);
    return static_cast<std::uint64_t>(std::min(limit, kMost));
}

}  // namespace

void Budget::spend(Cost cost, std::uint64_t amount, const std::string& file, const std::string& pointer)
{
    require(cost, amount, file, pointer);
    spent_[static_cast<std::size_t>(cost)] += amount;
}

void Budget::require(Cost cost, std::uint64_t amount, const std::string& file, const std::string& pointer) const
{
    if (amount <= left(cost)) return;
    const char* name = kLimits[static_cast<std::size_t>(cost)].name;
    throw Error({.what = fmt::format("too many {}", name),
                 .file = file,
                 .pointer = pointer,
                 .expected = fmt::format("at most {} in all; --budget-factor 2 doubles each such limit", most(cost))});
}

std::uint64_t Budget::left(Cost cost) const
{
    return most(cost) - std::min(most(cost), spent_[static_cast<std::size_t>(cost)]);
}

double& Budget::factor()
{
    static double factor = 1.0;
    return factor;
}

}  // namespace hw
