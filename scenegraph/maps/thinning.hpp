#pragma once

#include <cstdint>
#include <vector>

#include "hatchway/core/pixels.hpp"

namespace hw {

/// Ink or paper for each pixel of a drawing whose opposite sides touch.
struct InkMask {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> ink;  ///< 1 ink, 0 paper.

    std::size_t place(int x, int y) const
    {
        return static_cast<std::size_t>(wrapped(y, height)) * width + wrapped(x, width);
    }
    bool at(int x, int y) const { return ink[place(x, y)] != 0; }

 private:
    static int wrapped(int i, int size)
    {
        const bool is_inside = 0 <= i && i < size;  // nearly always: a division costs more than all else here
        return is_inside ? i : ((i % size) + size) % size;
    }
};

/// The pixels of a drawing darker than `ink_below` (0 black, 1 white); what is transparent is paper.
InkMask ink_of(const Pixels& drawing, double ink_below);

/// For each pixel about how far it is from paper, in pixels; 0 on paper. Chamfer distance, 4 % off at most.
std::vector<float> distance_to_paper(const InkMask& mask);

/// Thins ink to lines one pixel wide, joined as before. Source: Zhang, Suen. A Fast Parallel Algorithm for Thinning
/// Digital Patterns. CACM 27, 1984; then the corners of stairs are taken away.
InkMask thinned(const InkMask& mask);

}  // namespace hw
