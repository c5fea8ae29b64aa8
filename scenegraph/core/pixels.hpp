#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hw {

/// An image of 8 bits a channel, rows from top to bottom, channels interleaved, no padding.
struct Pixels {
    int width = 0;
    int height = 0;
    int channels = 0;  ///< 1 gray, 2 gray + alpha, 3 RGB, 4 RGBA.
    std::vector<std::uint8_t> bytes;

    bool is_empty() const { return bytes.empty(); }
    const std::uint8_t* at(int x, int y) const
    {
        return bytes.data() + (static_cast<std::size_t>(y) * width + x) * channels;
    }
    std::uint8_t* at(int x, int y) { return const_cast<std::uint8_t*>(static_cast<const Pixels*>(this)->at(x, y)); }
};

}  // namespace hw
