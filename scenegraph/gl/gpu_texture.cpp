#include "hatchway/gl/gpu_texture.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "hatchway/core/error.hpp"
#include "hatchway/gl/texture_format.hpp"

namespace hw {
namespace {

// Uploads and set-up use a unit of their own: the others hold what GpuState believes they hold.
constexpr GLenum kUploadUnit = GL_TEXTURE15;

GLint wrap_constant(WrapMode wrap)
{
    switch (wrap) {
        case WrapMode::repeat:
            return GL_REPEAT;
        case WrapMode::mirrored_repeat:
            return GL_MIRRORED_REPEAT;
        case WrapMode::clamp:
            break;
    }
    return GL_CLAMP_TO_EDGE;
}

GLint minifying_constant(FilterMode filter)
{
    switch (filter) {
        case FilterMode::nearest:
            return GL_NEAREST;
        case FilterMode::linear:
            return GL_LINEAR;
        case FilterMode::linear_in_level:
            return GL_LINEAR_MIPMAP_NEAREST;
        case FilterMode::trilinear:
            break;
    }
    return GL_LINEAR_MIPMAP_LINEAR;
}

void set_sampling(const TextureDesc& desc)
{
    const GLint minified = minifying_constant(desc.filter);
    const bool nearest = desc.is_magnified_nearest || desc.filter == FilterMode::nearest;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minified);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, nearest ? GL_NEAREST : GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap_constant(desc.wrap_u));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap_constant(desc.wrap_v));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, desc.levels - 1);
    if (desc.format == TextureFormat::depth24) {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    }
}

glm::ivec2 level_size(const TextureDesc& desc, int level)
{
    return {std::max(1, desc.size_px.x >> level), std::max(1, desc.size_px.y >> level)};
}

}  // namespace

FormatConstants format_constants(TextureFormat format)
{
    switch (format) {
        case TextureFormat::r8:
            return {GL_R8, GL_RED, GL_UNSIGNED_BYTE, 1};
        case TextureFormat::rg8:
            return {GL_RG8, GL_RG, GL_UNSIGNED_BYTE, 2};
        case TextureFormat::rgba8:
            return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4};
        case TextureFormat::srgb8_alpha8:
            return {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE, 4};
        case TextureFormat::rgba16f:
            return {GL_RGBA16F, GL_RGBA, GL_FLOAT, 16};
        case TextureFormat::r32f:
            return {GL_R32F, GL_RED, GL_FLOAT, 4};
        case TextureFormat::rgba32f:
            return {GL_RGBA32F, GL_RGBA, GL_FLOAT, 16};
        case TextureFormat::r32ui:
            return {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 4};
        case TextureFormat::rg32ui:
            return {GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT, 8};
        case TextureFormat::rgba32ui:
            return {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, 16};
        case TextureFormat::depth24_stencil8:
            return {GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, 4};
        case TextureFormat::depth24:
            break;
    }
    return {GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 4};
}

bool is_whole_number(TextureFormat format)
{
    return format == TextureFormat::r32ui || format == TextureFormat::rg32ui || format == TextureFormat::rgba32ui;
}

int full_level_count(glm::ivec2 size_px)
{
    int levels = 1;
    for (int side = std::max(size_px.x, size_px.y); side > 1; side >>= 1) ++levels;
    return levels;
}

GpuTexture::GpuTexture(const TextureDesc& desc) : desc_(desc)
{
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (desc.size_px.x < 1 || desc.size_px.y < 1 || std::max(desc.size_px.x, desc.size_px.y) > limit)
        throw Error({.what = "a texture of " + std::to_string(desc.size_px.x) + " x " + std::to_string(desc.size_px.y),
                     .expected = "1 to " + std::to_string(limit) + " pixels a side on this device",
                     .fault = Fault::device});
    if (desc_.levels == 0) desc_.levels = full_level_count(desc.size_px);
    const FormatConstants constants = format_constants(desc.format);
    glGenTextures(1, &id_);
    glActiveTexture(kUploadUnit);
    glBindTexture(GL_TEXTURE_2D, id_);
    for (int level = 0; level < desc_.levels; ++level) {
        const glm::ivec2 size = level_size(desc_, level);
        glTexImage2D(GL_TEXTURE_2D, level, constants.internal_format, size.x, size.y, 0, constants.format,
                     constants.type, nullptr);
    }
    set_sampling(desc_);
}

GpuTexture::~GpuTexture()
{
    if (id_ != 0) glDeleteTextures(1, &id_);
}

GpuTexture::GpuTexture(GpuTexture&& other) noexcept : id_(std::exchange(other.id_, 0)), desc_(other.desc_) {}

GpuTexture& GpuTexture::operator=(GpuTexture&& other) noexcept
{
    std::swap(id_, other.id_);
    std::swap(desc_, other.desc_);
    return *this;
}

void GpuTexture::upload(int level, std::span<const std::byte> bytes)
{
    const FormatConstants constants = format_constants(desc_.format);
    const glm::ivec2 size = level_size(desc_, level);
    HW_ASSERT(level >= 0 && level < desc_.levels);
    HW_ASSERT(bytes.size() == static_cast<std::size_t>(size.x) * size.y * constants.bytes_per_pixel);
    glActiveTexture(kUploadUnit);
    glBindTexture(GL_TEXTURE_2D, id_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, level, 0, 0, size.x, size.y, constants.format, constants.type, bytes.data());
}

void GpuTexture::make_levels()
{
    glActiveTexture(kUploadUnit);
    glBindTexture(GL_TEXTURE_2D, id_);
    glGenerateMipmap(GL_TEXTURE_2D);
}

}  // namespace hw
