#include "hatchway/io/images/jpeg.hpp"

#include <cstdio>

#include <jpeglib.h>

#include <csetjmp>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

// As for PNG: errors come by longjmp, so nothing with a destructor is created between setjmp and a call that may fail.

struct JpegErrors {
    jpeg_error_mgr base;
    std::jmp_buf jump;
    char text[JMSG_LENGTH_MAX] = "damaged";
};

void keep_error(j_common_ptr common)
{
    auto* errors = reinterpret_cast<JpegErrors*>(common->err);
    errors->base.format_message(common, errors->text);
    std::longjmp(errors->jump, 1);
}

void ignore_message(j_common_ptr) {}

/// A warning means damaged data that libjpeg would fill with gray. A picture with a hole is bad input; and a tiny file
/// that claims a huge progressive picture would keep the decoder busy for minutes on invented data.
void treat_warning_as_error(j_common_ptr common, int level)
{
    if (level < 0) keep_error(common);
}

struct JpegReader {
    JpegReader()
    {
        decompress.err = jpeg_std_error(&errors.base);
        errors.base.error_exit = keep_error;
        errors.base.output_message = ignore_message;
        errors.base.emit_message = treat_warning_as_error;
    }
    ~JpegReader() { jpeg_destroy_decompress(&decompress); }
    JpegReader(const JpegReader&) = delete;
    JpegReader& operator=(const JpegReader&) = delete;

    JpegErrors errors = {};
    jpeg_decompress_struct decompress = {};
};

bool read_header(JpegReader& reader, const ImageSource& source)
{
    if (setjmp(reader.errors.jump)) return false;
    jpeg_create_decompress(&reader.decompress);
    jpeg_mem_src(&reader.decompress, reinterpret_cast<const unsigned char*>(source.bytes.data()), source.bytes.size());
    jpeg_read_header(&reader.decompress, TRUE);
    return true;
}

bool start(JpegReader& reader)
{
    if (setjmp(reader.errors.jump)) return false;
    auto& jpeg = reader.decompress;
    const bool is_cmyk = jpeg.jpeg_color_space == JCS_CMYK || jpeg.jpeg_color_space == JCS_YCCK;
    jpeg.out_color_space = jpeg.jpeg_color_space == JCS_GRAYSCALE ? JCS_GRAYSCALE : is_cmyk ? JCS_CMYK : JCS_RGB;
    jpeg.dct_method = JDCT_ISLOW;
    jpeg_start_decompress(&jpeg);
    return true;
}

bool read_rows(JpegReader& reader, Pixels& pixels)
{
    if (setjmp(reader.errors.jump)) return false;
    while (reader.decompress.output_scanline < reader.decompress.output_height) {
        JSAMPROW row = pixels.at(0, static_cast<int>(reader.decompress.output_scanline));
        jpeg_read_scanlines(&reader.decompress, &row, 1);
    }
    jpeg_finish_decompress(&reader.decompress);
    return true;
}

/// Adobe stores CMYK inverted: 255 is no ink, so that channels multiply by black.
Pixels rgb_from_inverted_cmyk(const Pixels& cmyk)
{
    Pixels rgb{.width = cmyk.width, .height = cmyk.height, .channels = 3, .bytes = {}};
    rgb.bytes.reserve(static_cast<std::size_t>(rgb.width) * rgb.height * 3);
    for (std::size_t i = 0; i < cmyk.bytes.size(); i += 4)
        for (std::size_t channel = 0; channel < 3; ++channel)
            rgb.bytes.push_back(static_cast<std::uint8_t>(cmyk.bytes[i + channel] * cmyk.bytes[i + 3] / 255));
    return rgb;
}

}  // namespace

Pixels decode_jpeg(const ImageSource& source)
{
    JpegReader reader;
    const auto refuse = [&] {
        throw Error({.what = std::string("is a broken JPEG: ") + reader.errors.text, .file = source.name});
    };
    if (!read_header(reader, source)) refuse();
    check_image_size(reader.decompress.image_width, reader.decompress.image_height, source);
    if (!start(reader)) refuse();

    Pixels pixels;
    pixels.width = static_cast<int>(reader.decompress.output_width);
    pixels.height = static_cast<int>(reader.decompress.output_height);
    pixels.channels = reader.decompress.output_components;
    pixels.bytes.resize(static_cast<std::size_t>(pixels.width) * pixels.height * pixels.channels);
    if (!read_rows(reader, pixels)) refuse();
    return reader.decompress.out_color_space == JCS_CMYK ? rgb_from_inverted_cmyk(pixels) : pixels;
}

}  // namespace hw
