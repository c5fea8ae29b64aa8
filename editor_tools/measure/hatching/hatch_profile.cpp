#include "measure/hatching/hatch_profile.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "measure/no_value.hpp"

namespace hw {
namespace {

constexpr double kLeastInk = 0.02;         // of a pixel that belongs to a line
constexpr double kLeastShare = 1.0 / 3.0;  // of the stronger neighbour's ink, for a line that counts

struct Line {
    double at_px = 0.0;
    double ink_px = 0.0;
};

/// Lines are runs of pixels with more ink than the lightest pixel within one spacing. Runs cut off by the ends are
/// left.
std::vector<Line> lines_of(std::span<const double> ink, double spacing_px)
{
    const auto reach = static_cast<std::ptrdiff_t>(std::ceil(spacing_px));
    const auto size = static_cast<std::ptrdiff_t>(ink.size());
    std::vector<Line> lines;
    Line line;
    bool is_cut = true;
    for (std::ptrdiff_t i = 0; i < size; ++i) {
        const auto first = ink.begin() + std::max<std::ptrdiff_t>(0, i - reach);
        const auto last = ink.begin() + std::min(size, i + reach + 1);
        const double above = ink[i] - *std::min_element(first, last);
        if (above > kLeastInk) {
            line.at_px += above * (static_cast<double>(i) + 0.5);
            line.ink_px += above;
            continue;
        }
        if (line.ink_px > 0.0 && !is_cut) lines.push_back({line.at_px / line.ink_px, line.ink_px});
        line = {};
        is_cut = false;
    }
    return lines;
}

void add_spacings(HatchSamples& samples, const std::vector<Line>& lines, const HatchReference& reference)
{
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
        const double gap = lines[i + 1].at_px - lines[i].at_px;
        const double strong = std::max(lines[i].ink_px, lines[i + 1].ink_px);
        // As much ink as the weaker line and its like hold lies in lines one gap apart, the rest in lines two gaps
        // apart.
        const double wide = 2.0 * gap * strong / (lines[i].ink_px + lines[i + 1].ink_px);
        samples.ink_spacing.push_back(wide / reference.spacing_px - 1.0);
    }
    std::vector<Line> counted;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double before = i > 0 ? lines[i - 1].ink_px : 0.0;
        const double after = i + 1 < lines.size() ? lines[i + 1].ink_px : 0.0;
        if (lines[i].ink_px >= kLeastShare * std::max(before, after)) counted.push_back(lines[i]);
    }
    for (std::size_t i = 0; i + 1 < counted.size(); ++i)
        samples.spacing.push_back((counted[i + 1].at_px - counted[i].at_px) / reference.spacing_px - 1.0);
    for (const Line& line : counted) samples.width.push_back(line.ink_px / reference.line_px - 1.0);
}

}  // namespace

void add_profile(HatchSamples& samples, std::span<const double> ink, const HatchReference& reference)
{
    add_spacings(samples, lines_of(ink, reference.spacing_px), reference);
    const auto window = static_cast<std::size_t>(std::lround(2.0 * reference.spacing_px));
    if (ink.size() < window || window == 0) return;
    std::vector<double> tones;
    for (std::size_t i = 0; i + window <= ink.size(); ++i) {
        const std::span<const double> part = ink.subspan(i, window);
        tones.push_back(mean_of(part));
        const auto [least, most] = std::minmax_element(part.begin(), part.end());
        samples.contrast.push_back(*most - *least);
    }
    const double mean = mean_of(tones);
    for (double& tone : tones) {
        samples.tone.push_back(tone - reference.line_px / reference.spacing_px);
        tone -= mean;
    }
    samples.low_energy.push_back(root_mean_square(tones));
}

void add_samples(HatchSamples& samples, const HatchSamples& more)
{
    for (const auto part : {&HatchSamples::spacing, &HatchSamples::ink_spacing, &HatchSamples::width,
                            &HatchSamples::tone, &HatchSamples::contrast, &HatchSamples::low_energy})
        (samples.*part).insert((samples.*part).end(), (more.*part).begin(), (more.*part).end());
}

double absolute_quantile(std::vector<double> values, double share)
{
    if (values.empty()) return measure::kNoValue;
    for (double& value : values) value = std::abs(value);
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

double root_mean_square(std::span<const double> values)
{
    if (values.empty()) return measure::kNoValue;
    const double sum = std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
    return std::sqrt(sum / static_cast<double>(values.size()));
}

double mean_of(std::span<const double> values)
{
    return measure::share_of(std::accumulate(values.begin(), values.end(), 0.0), static_cast<double>(values.size()));
}

}  // namespace hw
