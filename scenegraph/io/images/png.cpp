#include "hatchway/io/images/png.hpp"

#include <png.h>

#include <csetjmp>
#include <cstring>
#include <limits>

#include "hatchway/core/error.hpp"
#include "hatchway/core/limits.hpp"

namespace hw {
namespace {

// libpng reports errors by longjmp, which skips destructors: between setjmp and the call that may fail nothing is
// created that has one. What must be released lives in the object that holds the jump buffer, outside of the
// jumped-over frame.

struct PngMessages {
    char text[200] = "damaged";
};

void keep_error(png_structp png, png_const_charp message)
{
    auto* messages = static_cast<PngMessages*>(png_get_error_ptr(png));
    std::strncpy(messages->text, message, sizeof(messages->text) - 1);
    png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

struct PngReader {
    explicit PngReader(std::span<const std::byte> source) : bytes(source)
    {
        png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &messages, keep_error, ignore_warning);
        if (png) info = png_create_info_struct(png);
    }
    ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    PngMessages messages;
    std::span<const std::byte> bytes;
    std::size_t place = 0;
    png_structp png = nullptr;
    png_infop info = nullptr;
    int passes = 1;
};

void read_from_memory(png_structp png, png_bytep target, png_size_t size)
{
    auto* reader = static_cast<PngReader*>(png_get_io_ptr(png));
    if (size > reader->bytes.size() - reader->place) png_error(png, "the file ends too early");
    std::memcpy(target, reader->bytes.data() + reader->place, size);
    reader->place += size;
}

bool read_header(PngReader& reader)
{
    if (setjmp(png_jmpbuf(reader.png))) return false;
    // Sizes and ancillary chunks are bounded by us, before libpng allocates rows or text.
    png_set_user_limits(reader.png, std::numeric_limits<png_int_32>::max(), std::numeric_limits<png_int_32>::max());
    png_set_chunk_cache_max(reader.png, 128);
    png_set_chunk_malloc_max(reader.png, 8 << 20);
    png_set_keep_unknown_chunks(reader.png, PNG_HANDLE_CHUNK_NEVER, nullptr, 0);
    png_set_read_fn(reader.png, &reader, read_from_memory);
    png_read_info(reader.png, reader.info);
    return true;
}

bool prepare_rows(PngReader& reader)
{
    if (setjmp(png_jmpbuf(reader.png))) return false;
    if (png_get_bit_depth(reader.png, reader.info) == 16) png_set_scale_16(reader.png);
    if (png_get_color_type(reader.png, reader.info) == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(reader.png);
    png_set_expand_gray_1_2_4_to_8(reader.png);
    if (png_get_valid(reader.png, reader.info, PNG_INFO_tRNS)) png_set_tRNS_to_alpha(reader.png);
    reader.passes = png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    return true;
}

bool read_rows(PngReader& reader, Pixels& pixels)
{
    if (setjmp(png_jmpbuf(reader.png))) return false;
    for (int pass = 0; pass < reader.passes; ++pass)
        for (int y = 0; y < pixels.height; ++y) png_read_row(reader.png, pixels.at(0, y), nullptr);
    return true;
}

struct PngWriter {
    PngWriter()
    {
        png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &messages, keep_error, ignore_warning);
        if (png) info = png_create_info_struct(png);
    }
    ~PngWriter() { png_destroy_write_struct(&png, &info); }
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;

    PngMessages messages;
    std::vector<std::byte> bytes;
    png_structp png = nullptr;
    png_infop info = nullptr;
};

void write_to_memory(png_structp png, png_bytep source, png_size_t size)
{
    auto& bytes = static_cast<PngWriter*>(png_get_io_ptr(png))->bytes;
    const auto* first = reinterpret_cast<const std::byte*>(source);
    bytes.insert(bytes.end(), first, first + size);
}

void nothing_to_flush(png_structp) {}

bool write_rows(PngWriter& writer, const Pixels& pixels)
{
    constexpr int kColourTypes[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                                    PNG_COLOR_TYPE_RGB_ALPHA};
    if (setjmp(png_jmpbuf(writer.png))) return false;
    png_set_write_fn(writer.png, &writer, write_to_memory, nothing_to_flush);
    png_set_IHDR(writer.png, writer.info, pixels.width, pixels.height, 8, kColourTypes[pixels.channels - 1],
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_BASE, PNG_FILTER_TYPE_BASE);
    png_set_filter(writer.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
    png_set_compression_level(writer.png, 5);
    png_write_info(writer.png, writer.info);
    for (int y = 0; y < pixels.height; ++y) png_write_row(writer.png, pixels.at(0, y));
    png_write_end(writer.png, nullptr);
    return true;
}

}  // namespace

Pixels decode_png(const ImageSource& source)
{
    PngReader reader(source.bytes);
    HW_ASSERT(reader.png && reader.info);
    const auto refuse = [&] {
        throw Error({.what = std::string("is a broken PNG: ") + reader.messages.text, .file = source.name});
    };
    if (!read_header(reader)) refuse();
    check_image_size(png_get_image_width(reader.png, reader.info), png_get_image_height(reader.png, reader.info),
                     source);
    if (!prepare_rows(reader)) refuse();

    Pixels pixels;
    pixels.width = static_cast<int>(png_get_image_width(reader.png, reader.info));
    pixels.height = static_cast<int>(png_get_image_height(reader.png, reader.info));
    pixels.channels = png_get_channels(reader.png, reader.info);
    HW_ASSERT(png_get_rowbytes(reader.png, reader.info) == static_cast<std::size_t>(pixels.width) * pixels.channels);
    pixels.bytes.resize(static_cast<std::size_t>(pixels.width) * pixels.height * pixels.channels);
    if (!read_rows(reader, pixels)) refuse();
    return pixels;
}

std::vector<std::byte> encode_png(const Pixels& pixels)
{
    HW_ASSERT(pixels.width > 0 && pixels.height > 0 && pixels.channels >= 1 && pixels.channels <= 4);
    HW_ASSERT(pixels.bytes.size() == static_cast<std::size_t>(pixels.width) * pixels.height * pixels.channels);
    PngWriter writer;
    HW_ASSERT(writer.png && writer.info);
    if (!write_rows(writer, pixels))
        throw Error({.what = std::string("cannot encode a PNG: ") + writer.messages.text, .fault = Fault::ours});
    return std::move(writer.bytes);
}

}  // namespace hw
