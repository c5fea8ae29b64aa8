#include "hatchway/io/images/images.hpp"

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/io/images/jpeg.hpp"
#include "hatchway/io/images/png.hpp"

namespace hw {
namespace {

bool starts_with(std::span<const std::byte> bytes, std::initializer_list<int> magic)
{
    return bytes.size() >= magic.size() &&
           std::equal(magic.begin(), magic.end(), bytes.begin(), [](int a, std::byte b) { return std::byte(a) == b; });
}

}  // namespace

Pixels decode_image(std::span<const std::byte> bytes, const std::string& name, std::uint64_t max_pixels)
{
    const ImageSource source{.bytes = bytes, .name = name, .max_pixels = max_pixels};
    if (starts_with(bytes, {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'})) return decode_png(source);
    if (starts_with(bytes, {0xff, 0xd8, 0xff})) return decode_jpeg(source);
    throw Error({.what = "is an image of an unknown format", .file = name, .expected = "PNG or JPEG"});
}

Pixels read_image(const std::filesystem::path& file)
{
    return decode_image(read_file(file, limits::kMaxFileBytes), file.string());
}

void write_png(const std::filesystem::path& file, const Pixels& pixels)
{
    write_file_atomically(file, encode_png(pixels));
}

}  // namespace hw
