#include "hatchway/gl/gpu_target.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "hatchway/core/error.hpp"
#include "hatchway/gl/texture_format.hpp"

namespace hw {
namespace {

void add_renderbuffer(std::vector<std::uint32_t>& ids, const GpuTargetDesc& desc, GLenum format, GLenum attachment)
{
    GLuint id = 0;
    glGenRenderbuffers(1, &id);
    ids.push_back(id);
    glBindRenderbuffer(GL_RENDERBUFFER, id);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, desc.samples > 1 ? desc.samples : 0, format, desc.size_px.x,
                                     desc.size_px.y);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, id);
}

void flip_rows(Pixels& pixels)
{
    const std::size_t row = static_cast<std::size_t>(pixels.width) * pixels.channels;
    for (int y = 0; y < pixels.height / 2; ++y)
        std::swap_ranges(pixels.at(0, y), pixels.at(0, y) + row, pixels.at(0, pixels.height - 1 - y));
}

}  // namespace

// The default constructor has made a whole object: what is below may throw, and the destructor cleans up.
GpuTarget::GpuTarget(const GpuTargetDesc& desc) : GpuTarget()
{
    desc_ = desc;
    glGenFramebuffers(1, &id_);
    glBindFramebuffer(GL_FRAMEBUFFER, id_);
    if (desc.samples > 1)
        attach_multisampled();
    else
        attach_textures();
    if (desc.colours.empty()) {
        const GLenum none = GL_NONE;
        glDrawBuffers(1, &none);
        glReadBuffer(GL_NONE);
    } else {
        std::array<GLenum, 8> buffers;
        for (std::size_t i = 0; i < desc.colours.size(); ++i) buffers[i] = GL_COLOR_ATTACHMENT0 + i;
        glDrawBuffers(static_cast<GLsizei>(desc.colours.size()), buffers.data());
    }
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error({.what = "the device cannot draw into a target of this kind", .fault = Fault::device});
}

void GpuTarget::attach_textures()
{
    for (std::size_t i = 0; i < desc_.colours.size(); ++i) {
        colours_.emplace_back(TextureDesc{.format = desc_.colours[i].format,
                                          .size_px = desc_.size_px,
                                          .wrap_u = desc_.colours[i].wrap,
                                          .wrap_v = desc_.colours[i].wrap,
                                          .filter = desc_.colours[i].filter});
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i), GL_TEXTURE_2D,
                               colours_[i].id(), 0);
    }
    if (desc_.is_shadow_map) {
        depth_ = GpuTexture({.format = TextureFormat::depth24, .size_px = desc_.size_px, .filter = FilterMode::linear});
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.id(), 0);
    } else if (desc_.has_depth_texture) {
        depth_ = GpuTexture(
            {.format = TextureFormat::depth24_stencil8, .size_px = desc_.size_px, .filter = FilterMode::nearest});
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, depth_.id(), 0);
    } else if (desc_.has_depth) {
        add_renderbuffer(renderbuffers_, desc_, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT);
    }
}

void GpuTarget::attach_multisampled()
{
    for (std::size_t i = 0; i < desc_.colours.size(); ++i)
        add_renderbuffer(renderbuffers_, desc_, format_constants(desc_.colours[i].format).internal_format,
                         GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
    if (desc_.has_depth) add_renderbuffer(renderbuffers_, desc_, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT);
}

GpuTarget::~GpuTarget()
{
    if (!renderbuffers_.empty())
        glDeleteRenderbuffers(static_cast<GLsizei>(renderbuffers_.size()), renderbuffers_.data());
    if (id_ != 0) glDeleteFramebuffers(1, &id_);
}

GpuTarget::GpuTarget(GpuTarget&& other) noexcept
{
    *this = std::move(other);
}

GpuTarget& GpuTarget::operator=(GpuTarget&& other) noexcept
{
    std::swap(desc_, other.desc_);
    std::swap(id_, other.id_);
    std::swap(colours_, other.colours_);
    std::swap(depth_, other.depth_);
    std::swap(renderbuffers_, other.renderbuffers_);
    return *this;
}

void GpuTarget::bind() const
{
    glBindFramebuffer(GL_FRAMEBUFFER, id_);
    glViewport(0, 0, desc_.size_px.x, desc_.size_px.y);
}

void GpuTarget::clear(const glm::vec4& colour) const
{
    for (std::size_t i = 0; i < desc_.colours.size(); ++i) clear_colour(static_cast<int>(i), colour);
    clear_depth();
}

void GpuTarget::clear_colour(int attachment, const glm::vec4& colour) const
{
    const bool is_known = attachment >= 0 && attachment < static_cast<int>(desc_.colours.size());
    if (is_known && is_whole_number(desc_.colours[attachment].format))
        glClearBufferuiv(GL_COLOR, attachment, &glm::uvec4(colour)[0]);
    else
        glClearBufferfv(GL_COLOR, attachment, &colour[0]);
}

void GpuTarget::clear_depth() const
{
    const GLfloat far_depth = 1.0f;
    if (desc_.is_shadow_map)
        glClearBufferfv(GL_DEPTH, 0, &far_depth);
    else if (desc_.has_depth)
        glClearBufferfi(GL_DEPTH_STENCIL, 0, far_depth, 0);
}

void GpuTarget::resolve_into(const GpuTarget& to) const
{
    HW_ASSERT(desc_.size_px == to.desc_.size_px);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, id_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.id_);
    glBlitFramebuffer(0, 0, desc_.size_px.x, desc_.size_px.y, 0, 0, desc_.size_px.x, desc_.size_px.y,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void GpuTarget::show_in_window(glm::ivec2 size_px) const
{
    glBindFramebuffer(GL_READ_FRAMEBUFFER, id_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    // The bytes go over as they are: whether a window counts as sRGB differs between systems.
    if (epoxy_is_desktop_gl()) glDisable(GL_FRAMEBUFFER_SRGB);
    glBlitFramebuffer(0, 0, desc_.size_px.x, desc_.size_px.y, 0, 0, size_px.x, size_px.y, GL_COLOR_BUFFER_BIT,
                      size_px == desc_.size_px ? GL_NEAREST : GL_LINEAR);
}

Pixels GpuTarget::read_rgb() const
{
    HW_ASSERT(desc_.samples == 1);
    const std::size_t count = static_cast<std::size_t>(desc_.size_px.x) * desc_.size_px.y;
    std::vector<std::uint8_t> rgba(count * 4);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, id_);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, desc_.size_px.x, desc_.size_px.y, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    Pixels pixels{.width = desc_.size_px.x, .height = desc_.size_px.y, .channels = 3, .bytes = {}};
    pixels.bytes.resize(count * 3);
    for (std::size_t i = 0; i < count; ++i) std::memcpy(&pixels.bytes[i * 3], &rgba[i * 4], 3);
    flip_rows(pixels);
    return pixels;
}

glm::vec4 GpuTarget::read_pixel(int x, int from_top) const
{
    HW_ASSERT(desc_.samples == 1);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, id_);
    const int y = desc_.size_px.y - 1 - from_top;
    const TextureFormat format = desc_.colours[0].format;
    if (format == TextureFormat::rgba16f || format == TextureFormat::rgba32f || format == TextureFormat::r32f) {
        glm::vec4 value(0.0f);
        glReadPixels(x, y, 1, 1, GL_RGBA, GL_FLOAT, &value[0]);
        return value;
    }
    std::array<std::uint8_t, 4> bytes{};
    glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    return glm::vec4(bytes[0], bytes[1], bytes[2], bytes[3]) / 255.0f;
}

std::vector<glm::uvec4> read_texture(std::uint32_t texture, glm::ivec2 size_px, bool is_whole_number)
{
    std::vector<glm::uvec4> pixels(static_cast<std::size_t>(size_px.x) * size_px.y);
    GLuint frame = 0;
    glGenFramebuffers(1, &frame);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size_px.x, size_px.y, is_whole_number ? GL_RGBA_INTEGER : GL_RGBA,
                 is_whole_number ? GL_UNSIGNED_INT : GL_FLOAT, pixels.data());
    glDeleteFramebuffers(1, &frame);
    return pixels;
}

void bind_window(glm::ivec2 size_px)
{
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, size_px.x, size_px.y);
}

}  // namespace hw
