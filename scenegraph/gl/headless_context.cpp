// EGL is linked directly: asking libepoxy for eglGetPlatformDisplay aborts before a display exists.
#include "hatchway/gl/headless_context.hpp"

#include "hatchway/gl/gl_api.hpp"
//
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstring>
#include <vector>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

[[noreturn]] void throw_no_device(const std::string& what)
{
    throw Error(
        {.what = what, .expected = "EGL without a surface, and OpenGL 3.3 or OpenGL ES 3.0", .fault = Fault::device});
}

EGLDisplay surfaceless_display()
{
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    EGLDisplay display = EGL_NO_DISPLAY;
    if (extensions != nullptr && std::strstr(extensions, "EGL_MESA_platform_surfaceless") != nullptr)
        display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY) display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr))
        throw_no_device("no headless graphics device");
    return display;
}

EGLConfig any_config(EGLDisplay display, bool is_es)
{
    const std::vector<EGLint> wanted = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                        is_es ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted.data(), &config, 1, &count) || count == 0) return nullptr;
    return config;
}

/// EGL_NO_CONTEXT where the display offers none of this kind.
EGLContext make_context(EGLDisplay display, const HeadlessOptions& options)
{
    if (!eglBindAPI(options.is_es ? EGL_OPENGL_ES_API : EGL_OPENGL_API)) return EGL_NO_CONTEXT;
    std::vector<EGLint> attributes = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, options.is_es ? 0 : 3};
    if (!options.is_es) {
        attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT});
        if (options.is_debug) attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE});
    }
    attributes.push_back(EGL_NONE);
    return eglCreateContext(display, any_config(display, options.is_es), EGL_NO_CONTEXT, attributes.data());
}

class HeadlessContext final : public Context {
 public:
    explicit HeadlessContext(const HeadlessOptions& options) : display_(surfaceless_display())
    {
        // EGL before 1.5 knows no debug contexts, and some devices have OpenGL ES alone.
        const HeadlessOptions without_debug{.is_es = options.is_es, .is_debug = false};
        const HeadlessOptions es{.is_es = true, .is_debug = false};
        for (const HeadlessOptions& wanted : {options, without_debug, es}) {
            context_ = make_context(display_, wanted);
            api_ = wanted.is_es ? EGL_OPENGL_ES_API : EGL_OPENGL_API;
            if (context_ != EGL_NO_CONTEXT) break;
        }
        if (context_ == EGL_NO_CONTEXT) throw_no_device("the headless device offers no context");
        HeadlessContext::make_current();
        start();
    }
    // The display stays open: other contexts of the process may live on it.
    ~HeadlessContext() override
    {
        eglBindAPI(api_);
        if (eglGetCurrentContext() == context_) eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, nullptr);
        eglDestroyContext(display_, context_);
    }
    void make_current() override
    {
        eglBindAPI(api_);
        if (eglGetCurrentContext() == context_) return;
        if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
            throw_no_device("the headless context cannot be used without a surface");
    }
    glm::ivec2 framebuffer_size_px() const override { return {0, 0}; }

 private:
    EGLDisplay display_;
    EGLenum api_ = EGL_OPENGL_API;
    EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<Context> make_headless_context(const HeadlessOptions& options)
{
    return std::make_unique<HeadlessContext>(options);
}

}  // namespace hw
