#include <gtest/gtest.h>

#include <cstdio>

#include <jpeglib.h>
#include <png.h>
#include <zlib.h>

#include <cstdlib>
#include <cstring>

#include "hatchway/io/images/images.hpp"
#include "hatchway/io/images/png.hpp"
#include "tests/io/expect_error.hpp"

namespace {

hw::Pixels gradient(int width, int height, int channels)
{
    hw::Pixels pixels{.width = width, .height = height, .channels = channels, .bytes = {}};
    for (int i = 0; i < width * height * channels; ++i) pixels.bytes.push_back(static_cast<std::uint8_t>(i * 7));
    return pixels;
}

std::vector<std::byte> jpeg_of(hw::Pixels pixels)
{
    jpeg_compress_struct jpeg = {};
    jpeg_error_mgr errors = {};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    unsigned char* memory = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&jpeg, &memory, &size);
    jpeg.image_width = static_cast<JDIMENSION>(pixels.width);
    jpeg.image_height = static_cast<JDIMENSION>(pixels.height);
    jpeg.input_components = pixels.channels;
    jpeg.in_color_space = pixels.channels == 1 ? JCS_GRAYSCALE : JCS_RGB;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, 95, TRUE);
    jpeg_start_compress(&jpeg, TRUE);
    for (int y = 0; y < pixels.height; ++y) {
        JSAMPROW row = pixels.at(0, y);
        jpeg_write_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_compress(&jpeg);
    jpeg_destroy_compress(&jpeg);
    const auto* first = reinterpret_cast<const std::byte*>(memory);
    std::vector<std::byte> bytes(first, first + size);
    std::free(memory);
    return bytes;
}

/// A PNG of any kind, written by libpng with rows as they are.
std::vector<std::byte> raw_png(int width, int height, int depth, int colour_type, const std::vector<std::uint8_t>& rows)
{
    std::vector<std::byte> bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &bytes,
        [](png_structp writer, png_bytep data, png_size_t size) {
            auto& target = *static_cast<std::vector<std::byte>*>(png_get_io_ptr(writer));
            const auto* first = reinterpret_cast<const std::byte*>(data);
            target.insert(target.end(), first, first + size);
        },
        nullptr);
    png_set_IHDR(png, info, width, height, depth, colour_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_BASE,
                 PNG_FILTER_TYPE_BASE);
    const png_color palette[] = {{10, 20, 30}, {40, 50, 60}};
    if (colour_type == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette, 2);
    png_write_info(png, info);
    const std::size_t row_bytes = png_get_rowbytes(png, info);
    for (int y = 0; y < height; ++y) png_write_row(png, rows.data() + y * row_bytes);
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

}  // namespace

TEST(images, a_png_reads_back_as_it_was_written_with_every_number_of_channels)
{
    for (int channels = 1; channels <= 4; ++channels) {
        const hw::Pixels pixels = gradient(13, 7, channels);
        const hw::Pixels read = hw::decode_image(hw::encode_png(pixels), "test.png");
        EXPECT_EQ(read.width, 13);
        EXPECT_EQ(read.height, 7);
        EXPECT_EQ(read.channels, channels);
        EXPECT_EQ(read.bytes, pixels.bytes);
    }
}

TEST(images, equal_pixels_give_equal_bytes)
{
    EXPECT_EQ(hw::encode_png(gradient(64, 64, 3)), hw::encode_png(gradient(64, 64, 3)));
}

TEST(images, sixteen_bits_become_eight)
{
    const hw::Pixels read =
        hw::decode_image(raw_png(2, 1, 16, PNG_COLOR_TYPE_GRAY, {0xff, 0xff, 0x80, 0x00}), "test.png");
    EXPECT_EQ(read.channels, 1);
    EXPECT_EQ(read.bytes, (std::vector<std::uint8_t>{255, 128}));
}

TEST(images, a_palette_becomes_rgb)
{
    const hw::Pixels read = hw::decode_image(raw_png(2, 1, 1, PNG_COLOR_TYPE_PALETTE, {0x40}), "test.png");
    EXPECT_EQ(read.channels, 3);
    EXPECT_EQ(read.bytes, (std::vector<std::uint8_t>{10, 20, 30, 40, 50, 60}));
}

TEST(images, one_bit_gray_becomes_black_and_white_of_one_channel)
{
    const hw::Pixels read = hw::decode_image(raw_png(3, 1, 1, PNG_COLOR_TYPE_GRAY, {0xa0}), "test.png");
    EXPECT_EQ(read.channels, 1);
    EXPECT_EQ(read.bytes, (std::vector<std::uint8_t>{255, 0, 255}));
}

TEST(images, a_jpeg_is_read_within_its_quality)
{
    hw::Pixels pixels{.width = 32, .height = 16, .channels = 3, .bytes = std::vector<std::uint8_t>(32 * 16 * 3, 100)};
    const hw::Pixels read = hw::decode_image(jpeg_of(pixels), "test.jpg");
    ASSERT_EQ(read.bytes.size(), pixels.bytes.size());
    for (const std::uint8_t value : read.bytes) EXPECT_NEAR(value, 100, 3);
}

TEST(images, a_gray_jpeg_keeps_one_channel)
{
    EXPECT_EQ(hw::decode_image(jpeg_of(gradient(16, 16, 1)), "test.jpg").channels, 1);
}

TEST(images, another_format_is_refused_by_name)
{
    const std::string webp = "RIFF....WEBPVP8 ";
    const auto parts = error_of([&] { hw::decode_image(std::as_bytes(std::span(webp)), "a.webp"); });
    EXPECT_EQ(parts.file, "a.webp");
    EXPECT_EQ(parts.expected, "PNG or JPEG");
}

TEST(images, a_png_cut_at_any_byte_is_refused)
{
    const std::vector<std::byte> bytes = hw::encode_png(gradient(8, 8, 3));
    // The last chunk holds no pixels: without it the picture is whole.
    for (std::size_t size = 0; size < bytes.size() - 12; ++size)
        EXPECT_THROW(hw::decode_image(std::span(bytes).first(size), "cut.png"), hw::Error) << size;
}

TEST(images, a_jpeg_cut_at_any_byte_is_refused)
{
    const std::vector<std::byte> bytes = jpeg_of(gradient(16, 16, 1));
    for (std::size_t size = 0; size < bytes.size() - 2; ++size)
        EXPECT_THROW(hw::decode_image(std::span(bytes).first(size), "cut.jpg"), hw::Error) << size;
}

TEST(images, a_picture_of_two_gigapixels_is_refused_before_it_is_allocated)
{
    std::vector<std::byte> bytes = hw::encode_png(gradient(8, 8, 1));
    const unsigned char size[8] = {0, 0, 0x80, 0, 0, 0, 0x80, 0};  // 32768 x 32768
    std::memcpy(bytes.data() + 16, size, 8);
    const auto crc = static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const unsigned char*>(bytes.data() + 12), 17));  // of the IHDR chunk
    for (int i = 0; i < 4; ++i) bytes[29 + i] = static_cast<std::byte>(crc >> (24 - 8 * i));
    const auto parts = error_of([&] { hw::decode_image(bytes, "bomb.png"); });
    EXPECT_THAT(parts.what, testing::HasSubstr("32768 x 32768"));
}

TEST(images, more_pixels_than_the_caller_allows_are_refused)
{
    EXPECT_THROW(hw::decode_image(hw::encode_png(gradient(8, 8, 1)), "a.png", 63), hw::Error);
    EXPECT_NO_THROW(hw::decode_image(hw::encode_png(gradient(8, 8, 1)), "a.png", 64));
}
