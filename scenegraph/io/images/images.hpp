#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "hatchway/core/limits.hpp"
#include "hatchway/core/pixels.hpp"

namespace hw {

/// Decodes a PNG or JPEG file, told apart by its first bytes. Palettes become RGB or RGBA, 16 bits become 8, gray stays
/// one channel (two with alpha), CMYK becomes RGB. Colours are left as stored: no gamma, no colour profile is applied.
/// `name` stands in messages. Throws hw::Error for another format, a damaged file, a side over limits::kMaxImageSide or
/// more than `max_pixels`; sizes are checked before anything is allocated.
Pixels decode_image(std::span<const std::byte> bytes, const std::string& name,
                    std::uint64_t max_pixels = limits::kMaxImagePixels);

/// Reads and decodes a file.
Pixels read_image(const std::filesystem::path& file);

/// Encodes and writes; readers see the old file or the new one. Throws hw::Error when the file cannot be written.
void write_png(const std::filesystem::path& file, const Pixels& pixels);

}  // namespace hw
