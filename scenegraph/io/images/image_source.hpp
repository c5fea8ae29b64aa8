#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace hw {

/// An encoded image of a stranger. Private to io.
struct ImageSource {
    std::span<const std::byte> bytes;
    const std::string& name;
    std::uint64_t max_pixels;
};

/// Throws hw::Error for a size over the limits. Called before the pixels are allocated.
void check_image_size(std::uint64_t width, std::uint64_t height, const ImageSource& source);

}  // namespace hw
