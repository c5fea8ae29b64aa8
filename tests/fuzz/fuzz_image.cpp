// PNG and JPEG files. What was decoded can be encoded and decoded again, and small ones can be read as a drawing.
#include "hatchway/io/images/images.hpp"
#include "hatchway/io/images/png.hpp"
#include "hatchway/maps/bitmap_strokes.hpp"
#include "tests/fuzz/target.hpp"

void hw::fuzz::try_bytes(std::string_view bytes)
{
    constexpr std::uint64_t kMaxPixels = 1 << 18;
    constexpr std::size_t kMostOfDrawing = 1 << 14;
    const Pixels pixels = decode_image(std::as_bytes(std::span(bytes)), "fuzz", kMaxPixels);
    require(decode_image(encode_png(pixels), "again").bytes == pixels.bytes);
    if (pixels.bytes.size() <= kMostOfDrawing) strokes_of_bitmap(pixels);
}
