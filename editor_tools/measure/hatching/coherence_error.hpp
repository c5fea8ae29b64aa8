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

/// A place of the surface that both frames see, pixels, with its surroundings of `kCoherenceReach` pixels.
struct SeenTwice {
    glm::dvec2 before{0.0};
    glm::dvec2 after{0.0};
    glm::dvec2 right{1.0, 0.0};  ///< Where a step of one pixel to the right of `before` goes, and one down.
    glm::dvec2 down{0.0, 1.0};
    glm::dvec2 bend_right{0.0};  ///< What is added to that by the square of a step to the right, ...
    glm::dvec2 bend_down{0.0};   ///< ... of a step down, ...
    glm::dvec2 bend_both{0.0};   ///< ... and by the product of both: of curved surfaces and of perspective.
    bool is_curved = false;      ///< Its surroundings are smooth, but no plane.

    glm::dvec2 moved(double i, double j) const
    {
        return after + i * right + j * down + i * i * bend_right + j * j * bend_down + i * j * bend_both;
    }
};
inline constexpr int kCoherenceReach = 8;

/// How ink changed at a place from one frame to the next.
struct CoherenceError {
    double flicker = 0.0;        ///< Change of the mean ink of 3 x 3 pixels.
    double pixel_flicker = 0.0;  ///< Mean change of ink of the pixels of a box of 16 pixels, each by itself.
    double tone = 0.0;           ///< Change of the mean ink of that box.
    double ink = 0.0;            ///< Mean ink of that box in both frames.
    double slide = -1.0;         ///< Way of marks over the surface, pixels, across them; below 0 where no marks are.
};

/// One for each place, in their order.
void add_coherence(std::vector<CoherenceError>& errors, const InkPicture& before, const InkPicture& after,
                   std::span<const SeenTwice> places);

}  // namespace hw
