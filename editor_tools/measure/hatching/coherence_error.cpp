#include "measure/hatching/coherence_error.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace hw {
namespace {

constexpr double kLeastGradient = 1.0;  // sum of squared steps of ink within the box, below which there are no marks

/// Ink around a place in both frames, the later one carried back along the surface.
struct Patch {
    static constexpr int kSide = 2 * kCoherenceReach + 1;
    double before[kSide][kSide];
    double after[kSide][kSide];

    double mean(int x, int y) const { return 0.5 * (before[y][x] + after[y][x]); }
    glm::dvec2 gradient(int x, int y) const
    {
        return 0.5 * glm::dvec2(mean(x + 1, y) - mean(x - 1, y), mean(x, y + 1) - mean(x, y - 1));
    }
};

Patch patch_of(const InkPicture& before, const InkPicture& after, const SeenTwice& place)
{
    Patch patch{};
    for (int y = 0; y < Patch::kSide; ++y)
        for (int x = 0; x < Patch::kSide; ++x) {
            const double i = x - kCoherenceReach;
            const double j = y - kCoherenceReach;
            patch.before[y][x] = before.sample(place.before + glm::dvec2(i, j));
            patch.after[y][x] = after.sample(place.moved(i, j));
        }
    return patch;
}

double mean_change(const Patch& patch, int reach)
{
    double sum = 0.0;
    for (int y = kCoherenceReach - reach; y <= kCoherenceReach + reach; ++y)
        for (int x = kCoherenceReach - reach; x <= kCoherenceReach + reach; ++x)
            sum += patch.after[y][x] - patch.before[y][x];
    return std::abs(sum) / ((2 * reach + 1) * (2 * reach + 1));
}

template <typename Value>
double mean_over(const Value& value)
{
    double sum = 0.0;
    for (int y = 0; y < Patch::kSide; ++y)
        for (int x = 0; x < Patch::kSide; ++x) sum += value(x, y);
    return sum / (Patch::kSide * Patch::kSide);
}

double mean_pixel_change(const Patch& patch)
{
    return mean_over([&](int x, int y) { return std::abs(patch.after[y][x] - patch.before[y][x]); });
}

double mean_ink(const Patch& patch)
{
    return mean_over([&](int x, int y) { return patch.mean(x, y); });
}

/// The direction in which ink changes most: along a stroke nobody sees it move. Zero where there are no marks.
glm::dvec2 way_across(const Patch& patch)
{
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (int y = 1; y + 1 < Patch::kSide; ++y)
        for (int x = 1; x + 1 < Patch::kSide; ++x) {
            const glm::dvec2 step = patch.gradient(x, y);
            xx += step.x * step.x;
            xy += step.x * step.y;
            yy += step.y * step.y;
        }
    if (xx + yy < kLeastGradient) return {};
    const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);
    return {std::cos(angle), std::sin(angle)};
}

/// Lucas and Kanade's shift across the marks, beside a gain and an offset of the ink, so that marks that only grow or
/// pale do not seem to move. Negative where there are no marks.
double slide_of(const Patch& patch)
{
    const glm::dvec2 way = way_across(patch);
    if (way == glm::dvec2(0.0)) return -1.0;
    glm::dmat3 sums(0.0);
    glm::dvec3 changes(0.0);
    for (int y = 1; y + 1 < Patch::kSide; ++y)
        for (int x = 1; x + 1 < Patch::kSide; ++x) {
            const glm::dvec3 row(glm::dot(way, patch.gradient(x, y)), patch.mean(x, y), 1.0);
            sums += glm::outerProduct(row, row);
            changes += (patch.after[y][x] - patch.before[y][x]) * row;
        }
    if (std::abs(glm::determinant(sums)) < 1e-9) return -1.0;
    return std::abs((glm::inverse(sums) * changes).x);
}

}  // namespace

double InkPicture::sample(const glm::dvec2& at_px) const
{
    const double x = std::clamp(at_px.x - 0.5, 0.0, width - 1.0);
    const double y = std::clamp(at_px.y - 0.5, 0.0, height - 1.0);
    const int left = std::min(static_cast<int>(x), width - 2);
    const int top = std::min(static_cast<int>(y), height - 2);
    const double u = x - left;
    const double v = y - top;
    return (1.0 - v) * ((1.0 - u) * at(left, top) + u * at(left + 1, top)) +
           v * ((1.0 - u) * at(left, top + 1) + u * at(left + 1, top + 1));
}

void add_coherence(std::vector<CoherenceError>& errors, const InkPicture& before, const InkPicture& after,
                   std::span<const SeenTwice> places)
{
    for (const SeenTwice& place : places) {
        const Patch patch = patch_of(before, after, place);
        errors.push_back({.flicker = mean_change(patch, 1),
                          .pixel_flicker = mean_pixel_change(patch),
                          .tone = mean_change(patch, kCoherenceReach),
                          .ink = mean_ink(patch),
                          .slide = slide_of(patch)});
    }
}

}  // namespace hw
