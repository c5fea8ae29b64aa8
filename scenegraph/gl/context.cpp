#include "hatchway/gl/context.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "hatchway/core/error.hpp"
#include "hatchway/gl/gl_api.hpp"

namespace hw {
namespace {

void GLAPIENTRY keep_message(GLenum source, GLenum type, GLuint, GLenum, GLsizei length, const GLchar* text,
                             const void* messages)
{
    // What the shader compiler says arrives as hw::Error.
    if (type != GL_DEBUG_TYPE_ERROR || source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;
    auto* list = static_cast<std::vector<std::string>*>(const_cast<void*>(messages));
    if (list->size() < 100) list->emplace_back(text, length < 0 ? std::string::npos : static_cast<std::size_t>(length));
}

std::string gl_string(GLenum name)
{
    const GLubyte* text = glGetString(name);
    return text == nullptr ? "" : reinterpret_cast<const char*>(text);
}

DeviceKind& taken_for()
{
    static DeviceKind kind = DeviceKind::as_found;
    return kind;
}

bool is_software(const std::string& renderer)
{
    if (taken_for() != DeviceKind::as_found) return taken_for() == DeviceKind::software;
    return std::ranges::any_of(std::array{"llvmpipe", "softpipe", "SwiftShader"},
                               [&](const char* name) { return renderer.find(name) != std::string::npos; });
}

DeviceInfo ask_device()
{
    DeviceInfo info;
    info.vendor = gl_string(GL_VENDOR);
    info.renderer = gl_string(GL_RENDERER);
    info.version = gl_string(GL_VERSION);
    info.is_software = is_software(info.renderer);
    info.is_es = !epoxy_is_desktop_gl();
    if (epoxy_gl_version() < (info.is_es ? 30 : 33))
        throw Error({.what = "this device offers " + info.version,
                     .expected = "OpenGL 3.3 or OpenGL ES 3.0",
                     .fault = Fault::device});
    std::array<float, 2> range{1.0f, 1.0f};
    glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range.data());
    info.max_line_width_px = range[1];
    if (info.is_es)
        glGetFloatv(GL_ALIASED_POINT_SIZE_RANGE, range.data());
    else
        glGetFloatv(GL_POINT_SIZE_RANGE, range.data());
    info.max_point_size_px = range[1];
    glGetIntegerv(GL_MAX_SAMPLES, &info.max_samples);
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &info.max_texture_side);
    info.has_float_targets = !info.is_es || epoxy_has_gl_extension("GL_EXT_color_buffer_float");
    return info;
}

const char* error_name(GLenum error)
{
    switch (error) {
        case GL_INVALID_ENUM:
            return "GL_INVALID_ENUM";
        case GL_INVALID_VALUE:
            return "GL_INVALID_VALUE";
        case GL_INVALID_OPERATION:
            return "GL_INVALID_OPERATION";
        case GL_INVALID_FRAMEBUFFER_OPERATION:
            return "GL_INVALID_FRAMEBUFFER_OPERATION";
        case GL_OUT_OF_MEMORY:
            return "GL_OUT_OF_MEMORY";
        default:
            return "an unknown GL error";
    }
}

}  // namespace

void take_devices_for(DeviceKind kind)
{
    taken_for() = kind;
}

void Context::start()
{
    device_ = ask_device();
    const bool is_core = epoxy_gl_version() >= (device_.is_es ? 32 : 43);
    // In ES the extension's entry points have a suffix that the core's have not; glGetError serves there.
    has_debug_messages_ = is_core || (!device_.is_es && epoxy_has_gl_extension("GL_KHR_debug"));
    if (!has_debug_messages_) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(keep_message, messages_.get());
}

std::vector<std::string> Context::take_errors()
{
    make_current();
    std::vector<std::string> errors = std::exchange(*messages_, {});
    for (int i = 0; i < 8; ++i) {
        const GLenum error = glGetError();
        if (error == GL_NO_ERROR) break;
        if (errors.empty() || !has_debug_messages_) errors.emplace_back(error_name(error));
    }
    return errors;
}

}  // namespace hw
