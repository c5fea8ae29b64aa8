#pragma once

#include "hatchway/core/pixels.hpp"
#include "hatchway/io/images/image_source.hpp"

namespace hw {

/// Decodes a JPEG; the rest of the contract is decode_image()'s. Private to io.
Pixels decode_jpeg(const ImageSource& source);

}  // namespace hw
