#pragma once

#include "hatchway/gl/gl_api.hpp"
#include "hatchway/gl/gpu_texture.hpp"

namespace hw {

/// The constants of a format, for calls inside of gl/.
struct FormatConstants {
    GLint internal_format;
    GLenum format;
    GLenum type;
    int bytes_per_pixel;
};

FormatConstants format_constants(TextureFormat format);

}  // namespace hw
