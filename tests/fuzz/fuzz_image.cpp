// Images: any bytes must decode or be refused by hw::Error. What was decoded can be encoded and decoded again.

#include <cstdint>
#include <cstdlib>

#include "hatchway/core/error.hpp"
#include "hatchway/io/images/images.hpp"
#include "hatchway/io/images/png.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    constexpr std::uint64_t kMaxPixels = 1 << 18;
    hw::Pixels pixels;
    try {
        pixels = hw::decode_image(std::as_bytes(std::span(data, size)), "fuzz", kMaxPixels);
    } catch (const hw::Error&) {
        return 0;
    }
    if (hw::decode_image(hw::encode_png(pixels), "again").bytes != pixels.bytes) std::abort();
    return 0;
}
