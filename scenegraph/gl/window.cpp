#include "hatchway/gl/window.hpp"

#include "hatchway/gl/gl_api.hpp"
//
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <utility>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

// clang-format off
constexpr std::array<int, kKeyCount> kKeyConstants = {
    GLFW_KEY_UNKNOWN,
    GLFW_KEY_A, GLFW_KEY_B, GLFW_KEY_C, GLFW_KEY_D, GLFW_KEY_E, GLFW_KEY_F, GLFW_KEY_G, GLFW_KEY_H, GLFW_KEY_I,
    GLFW_KEY_J, GLFW_KEY_K, GLFW_KEY_L, GLFW_KEY_M, GLFW_KEY_N, GLFW_KEY_O, GLFW_KEY_P, GLFW_KEY_Q, GLFW_KEY_R,
    GLFW_KEY_S, GLFW_KEY_T, GLFW_KEY_U, GLFW_KEY_V, GLFW_KEY_W, GLFW_KEY_X, GLFW_KEY_Y, GLFW_KEY_Z,
    GLFW_KEY_0, GLFW_KEY_1, GLFW_KEY_2, GLFW_KEY_3, GLFW_KEY_4, GLFW_KEY_5, GLFW_KEY_6, GLFW_KEY_7, GLFW_KEY_8,
    GLFW_KEY_9,
    GLFW_KEY_F1, GLFW_KEY_F2, GLFW_KEY_F3, GLFW_KEY_F4, GLFW_KEY_F5, GLFW_KEY_F6, GLFW_KEY_F7, GLFW_KEY_F8,
    GLFW_KEY_F9, GLFW_KEY_F10, GLFW_KEY_F11, GLFW_KEY_F12,
    GLFW_KEY_UP, GLFW_KEY_DOWN, GLFW_KEY_LEFT, GLFW_KEY_RIGHT, GLFW_KEY_PAGE_UP, GLFW_KEY_PAGE_DOWN, GLFW_KEY_HOME,
    GLFW_KEY_END, GLFW_KEY_SPACE, GLFW_KEY_ENTER, GLFW_KEY_TAB, GLFW_KEY_ESCAPE, GLFW_KEY_BACKSPACE, GLFW_KEY_INSERT,
    GLFW_KEY_DELETE,
    GLFW_KEY_LEFT_SHIFT, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_LEFT_ALT, GLFW_KEY_LEFT_SUPER, GLFW_KEY_EQUAL, GLFW_KEY_MINUS,
    GLFW_KEY_COMMA, GLFW_KEY_PERIOD, GLFW_KEY_SLASH, GLFW_KEY_GRAVE_ACCENT,
};
// clang-format on

int left_of_pair(int key)
{
    switch (key) {
        case GLFW_KEY_RIGHT_SHIFT:
            return GLFW_KEY_LEFT_SHIFT;
        case GLFW_KEY_RIGHT_CONTROL:
            return GLFW_KEY_LEFT_CONTROL;
        case GLFW_KEY_RIGHT_ALT:
            return GLFW_KEY_LEFT_ALT;
        case GLFW_KEY_RIGHT_SUPER:
            return GLFW_KEY_LEFT_SUPER;
        case GLFW_KEY_KP_ENTER:
            return GLFW_KEY_ENTER;
        case GLFW_KEY_KP_ADD:
            return GLFW_KEY_EQUAL;
        case GLFW_KEY_KP_SUBTRACT:
            return GLFW_KEY_MINUS;
        default:
            return key;
    }
}

Key key_of(int constant)
{
    static const std::map<int, Key> keys = [] {
        std::map<int, Key> all;
        for (int i = 1; i < kKeyCount; ++i) all[kKeyConstants[i]] = static_cast<Key>(i);
        return all;
    }();
    const auto found = keys.find(left_of_pair(constant));
    return found == keys.end() ? Key::unknown : found->second;
}

char letter_of(int constant, int scancode)
{
    const char* name = glfwGetKeyName(constant, scancode);
    const bool is_letter = name != nullptr && name[0] >= 'a' && name[0] <= 'z' && name[1] == '\0';
    return is_letter ? name[0] : '\0';
}

/// In screen units, from the top left.
struct ScreenRect {
    int x = 0, y = 0, width = 0, height = 0;
};

int overlap(const ScreenRect& a, const ScreenRect& b)
{
    const int width = std::min(a.x + a.width, b.x + b.width) - std::max(a.x, b.x);
    const int height = std::min(a.y + a.height, b.y + b.height) - std::max(a.y, b.y);
    return std::max(width, 0) * std::max(height, 0);
}

/// The monitor on which most of `rect` lies; null when there is none.
GLFWmonitor* monitor_of(const ScreenRect& rect)
{
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    const auto shown = [&](GLFWmonitor* monitor) {
        const GLFWvidmode* mode = glfwGetVideoMode(monitor);
        ScreenRect screen{.width = mode->width, .height = mode->height};
        glfwGetMonitorPos(monitor, &screen.x, &screen.y);
        return overlap(rect, screen);
    };
    return count == 0 ? nullptr : *std::ranges::max_element(monitors, monitors + count, {}, shown);
}

[[noreturn]] void throw_glfw_error(const std::string& doing)
{
    const char* reason = nullptr;
    glfwGetError(&reason);
    throw Error({.what = doing + (reason == nullptr ? "" : std::string(": ") + reason),
                 .expected = "a display with OpenGL 3.3; without one, use: hatchway render",
                 .fault = Fault::device});
}

/// GLFW itself is open while a window is.
class GlfwLibrary {
 public:
    GlfwLibrary()
    {
        if (!glfwInit()) throw_glfw_error("cannot open a window");
    }
    ~GlfwLibrary() { glfwTerminate(); }
    GlfwLibrary(const GlfwLibrary&) = delete;
    GlfwLibrary& operator=(const GlfwLibrary&) = delete;
};

class GlfwWindow final : public Window {
 public:
    explicit GlfwWindow(const WindowOptions& options)
    {
        glfwDefaultWindowHints();
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_SRGB_CAPABLE, GLFW_TRUE);
        glfwWindowHint(GLFW_DEPTH_BITS, 0);
        glfwWindowHint(GLFW_STENCIL_BITS, 0);
        glfwWindowHint(GLFW_VISIBLE, options.is_visible ? GLFW_TRUE : GLFW_FALSE);
        window_ = glfwCreateWindow(options.size.x, options.size.y, options.title.c_str(), nullptr, nullptr);
        if (window_ == nullptr) throw_glfw_error("cannot open a window");
        glfwSetWindowUserPointer(window_, this);
        GlfwWindow::make_current();
        glfwSwapInterval(options.is_vsynced ? 1 : 0);
        listen();
        start();
    }
    ~GlfwWindow() override
    {
        if (window_ != nullptr) glfwDestroyWindow(window_);
    }

    void make_current() override
    {
        if (glfwGetCurrentContext() != window_) glfwMakeContextCurrent(window_);
    }
    glm::ivec2 framebuffer_size_px() const override
    {
        glm::ivec2 size(0);
        glfwGetFramebufferSize(window_, &size.x, &size.y);
        return size;
    }
    InputEvents poll() override
    {
        glfwPollEvents();
        return std::exchange(events_, {});
    }
    void wait(double seconds) override { glfwWaitEventsTimeout(seconds); }
    bool is_down(Key key) const override { return are_down_[static_cast<int>(key)]; }
    bool is_down(MouseButton button) const override
    {
        return glfwGetMouseButton(window_, static_cast<int>(button)) == GLFW_PRESS;
    }
    glm::dvec2 cursor_px() const override
    {
        glm::dvec2 place(0.0);
        glfwGetCursorPos(window_, &place.x, &place.y);
        return place;
    }
    void capture_cursor(bool is_captured) override
    {
        is_captured_ = is_captured;
        glfwSetInputMode(window_, GLFW_CURSOR, is_captured ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
        if (glfwRawMouseMotionSupported()) glfwSetInputMode(window_, GLFW_RAW_MOUSE_MOTION, is_captured);
        // The cursor jumps when its mode changes: that is no motion of the hand.
        last_cursor_ = cursor_px();
    }
    bool is_cursor_captured() const override { return is_captured_; }
    float content_scale() const override
    {
        float x = 1.0f;
        float y = 1.0f;
        glfwGetWindowContentScale(window_, &x, &y);
        return x;
    }
    void swap() override { glfwSwapBuffers(window_); }
    bool should_close() const override { return glfwWindowShouldClose(window_) != 0; }
    void close() override { glfwSetWindowShouldClose(window_, GLFW_TRUE); }
    void set_title(const std::string& title) override { glfwSetWindowTitle(window_, title.c_str()); }
    bool is_full_screen() const override { return glfwGetWindowMonitor(window_) != nullptr; }
    void set_full_screen(bool is_full) override
    {
        if (is_full == is_full_screen()) return;
        if (!is_full) {
            glfwSetWindowMonitor(window_, nullptr, windowed_.x, windowed_.y, windowed_.width, windowed_.height, 0);
            return;
        }
        glfwGetWindowPos(window_, &windowed_.x, &windowed_.y);
        glfwGetWindowSize(window_, &windowed_.width, &windowed_.height);
        GLFWmonitor* monitor = monitor_of(windowed_);
        if (monitor == nullptr) return;
        const GLFWvidmode* mode = glfwGetVideoMode(monitor);
        glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    }

 private:
    static GlfwWindow& self(GLFWwindow* window) { return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window)); }

    void listen()
    {
        last_cursor_ = cursor_px();
        glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int scancode, int action, int modifiers) {
            self(window).key(key_of(key), letter_of(key, scancode), action, modifiers);
        });
        glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int) {
            GlfwWindow& me = self(window);
            if (button <= GLFW_MOUSE_BUTTON_MIDDLE)
                me.events_.buttons.push_back({static_cast<MouseButton>(button), action == GLFW_PRESS, me.cursor_px()});
        });
        glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double x, double y) {
            GlfwWindow& me = self(window);
            me.events_.motion += glm::dvec2(x, y) - std::exchange(me.last_cursor_, glm::dvec2(x, y));
        });
        glfwSetScrollCallback(
            window_, [](GLFWwindow* window, double x, double y) { self(window).events_.scroll += glm::dvec2(x, y); });
        glfwSetFramebufferSizeCallback(window_,
                                       [](GLFWwindow* window, int, int) { self(window).events_.needs_redraw = true; });
        glfwSetWindowRefreshCallback(window_, [](GLFWwindow* window) { self(window).events_.needs_redraw = true; });
        glfwSetWindowFocusCallback(window_, [](GLFWwindow* window, int is_focused) {
            if (is_focused) return;
            self(window).events_.lost_focus = true;
            self(window).are_down_.fill(false);
        });
        glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
            for (int i = 0; i < count; ++i) self(window).events_.dropped_files.emplace_back(paths[i]);
        });
    }

    void key(Key key, char letter, int action, int modifiers)
    {
        are_down_[static_cast<int>(key)] = action != GLFW_RELEASE;
        events_.keys.push_back({.key = key,
                                .is_down = action != GLFW_RELEASE,
                                .is_repeat = action == GLFW_REPEAT,
                                .with_shift = (modifiers & GLFW_MOD_SHIFT) != 0,
                                .with_control = (modifiers & GLFW_MOD_CONTROL) != 0,
                                .with_alt = (modifiers & GLFW_MOD_ALT) != 0,
                                .letter = letter});
    }

    GlfwLibrary library_;
    GLFWwindow* window_ = nullptr;
    InputEvents events_;
    std::array<bool, kKeyCount> are_down_{};
    glm::dvec2 last_cursor_{0.0};
    bool is_captured_ = false;
    ScreenRect windowed_;  ///< Where the window goes back to from the full screen.
};

}  // namespace

std::unique_ptr<Window> make_window(const WindowOptions& options)
{
    return std::make_unique<GlfwWindow>(options);
}

bool has_display()
{
    const auto is_set = [](const char* name) {
        const char* value = std::getenv(name);
        return value != nullptr && *value != '\0';
    };
    return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
}

}  // namespace hw
