#pragma once

#include <span>
#include <vector>

namespace hw {

/// What ideal hatching would show: lines of one width, one spacing.
struct HatchReference {
    double spacing_px = 8.0;
    double line_px = 1.25;
};

/// What pixels across hatching show, each number against the reference. Shares: 0 is right, 0.1 is a tenth too much.
struct HatchSamples {
    std::vector<double> spacing;      ///< Between neighbouring lines; a line below a third of its neighbour is none.
    std::vector<double> ink_spacing;  ///< The same, with weak lines counted by their ink.
    std::vector<double> width;        ///< Ink of a line.
    std::vector<double> tone;         ///< Ink coverage over two spacings less that of the reference.
    std::vector<double> contrast;     ///< Darkest less lightest pixel within two spacings.
    std::vector<double> low_energy;   ///< Of each profile: RMS of the tone around its own mean: energy below the line
                                      ///< frequency, which the eye sees as moiré.
};

/// Adds what one row of pixels across the lines shows. `ink`: linear coverage of each pixel.
void add_profile(HatchSamples& samples, std::span<const double> ink, const HatchReference& reference);

/// Adds all of `more`.
void add_samples(HatchSamples& samples, const HatchSamples& more);

// Of nothing these are measure::kNoValue.

/// The value below which this share of the absolute values lies.
double absolute_quantile(std::vector<double> values, double share);
double root_mean_square(std::span<const double> values);
double mean_of(std::span<const double> values);

}  // namespace hw
