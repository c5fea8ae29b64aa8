#pragma once

#include <cstddef>
#include <vector>

#include "hatchway/core/pixels.hpp"
#include "hatchway/io/images/image_source.hpp"

namespace hw {

/// Decodes a PNG; the rest of the contract is decode_image()'s. Private to io.
Pixels decode_png(const ImageSource& source);

/// Encodes as PNG. Equal pixels give equal bytes: no time stamp, fixed filter and compression.
std::vector<std::byte> encode_png(const Pixels& pixels);

}  // namespace hw
