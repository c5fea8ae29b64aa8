#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace hw {

/// Linear ink coverage of a picture, rows from top to bottom.
struct InkPicture {
    int width = 0;
    int height = 0;
    std::vector<float> ink;

    float at(int x, int y) const { return ink[static_cast<std::size_t>(y) * width + x]; }
    /// Between pixel centres, which lie at halves. The border repeats.
    double sample(const glm::dvec2& at_px) const;
};

/// A place of the surface that both frames see, pixels. Its surroundings of `kCoherenceReach` pixels are one flat
/// surface.
struct SeenTwice {
    glm::dvec2 before{0.0};
    glm::dvec2 after{0.0};
    glm::dvec2 right{1.0, 0.0};  ///< Where a step of one pixel to the right of `before` goes, and one down.
    glm::dvec2 down{0.0, 1.0};
};
inline constexpr int kCoherenceReach = 8;

/// How ink changed at places from one frame to the next.
struct CoherenceErrors {
    std::vector<double> flicker;  ///< Change of ink within 3 x 3 pixels.
    std::vector<double> tone;     ///< Change of the mean ink of a box of 16 pixels.
    std::vector<double> slide;    ///< Way of marks over the surface, pixels, across them; only where there are marks.
};

void add_coherence(CoherenceErrors& errors, const InkPicture& before, const InkPicture& after,
                   std::span<const SeenTwice> places);

}  // namespace hw
