#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "hatchway/core/pixels.hpp"
#include "measure/no_value.hpp"

namespace hw {

/// A picture as shares of ink: 0 paper, 1 full ink, linear light, rows from top to bottom.
struct InkImage {
    int width = 0;
    int height = 0;
    std::vector<float> ink;

    float at(int x, int y) const { return ink[static_cast<std::size_t>(y) * width + x]; }
    float& at(int x, int y) { return ink[static_cast<std::size_t>(y) * width + x]; }
};

/// The ink of a drawing in black on white.
InkImage ink_of(const Pixels& picture);

/// Mean share of ink over the whole picture.
double ink_share(const InkImage& image);

/// A polyline that ought to be drawn, whole, with round ends.
struct WantedLine {
    std::vector<glm::dvec2> points_px;  ///< Origin top left, y down. A closed one repeats its first point.
    double width_px = 1.0;
};

/// Error of a drawing, counted so that those of several pictures can be added.
struct LineError {
    double wanted_px = 0.0;  ///< Length of all wanted lines of a quarter of a pixel and more.
    double missed_px = 0.0;  ///< ... of that without ink within a pixel.
    double ink_px = 0.0;     ///< All ink.
    double leaked_px = 0.0;  ///< ... of that farther than half a width + 1 px from every wanted line.
    int gaps = 0;            ///< Missed stretches inside a line, with ink before and after.
    /// Drawn width / wanted width, every half pixel of lines that stand alone.
    std::vector<float> width_ratios;

    // No value of nothing: where no line is wanted, no ink is there, no line stands alone.
    double missed_share() const { return measure::share_of(missed_px, wanted_px); }
    double leaked_share() const { return measure::share_of(leaked_px, ink_px); }
    double gaps_per_1000_px() const { return measure::share_of(1000.0 * gaps, wanted_px); }
    /// Of the width ratios; `share` in [0, 1].
    double width_quantile(double share) const;

    void add(const LineError& other);
};

/// Judges a drawing by the lines that ought to be in it. `pixels_to_show`, when not null, receives for every pixel 1
/// where ink leaked, 2 where a line is missed: a picture to look at.
LineError line_error(const InkImage& drawing, std::span<const WantedLine> wanted,
                     std::vector<unsigned char>* pixels_to_show = nullptr);

}  // namespace hw
