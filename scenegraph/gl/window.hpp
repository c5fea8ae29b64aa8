#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <string>

#include "hatchway/gl/context.hpp"
#include "hatchway/gl/input.hpp"

namespace hw {

struct WindowOptions {
    std::string title = "Hatchway";
    glm::ivec2 size{1280, 720};  ///< Screen units: pixels divided by the content scale on some systems.
    bool is_vsynced = true;
    bool is_visible = true;
};

/// A window with its context.
class Window : public Context {
 public:
    /// Gathers events; does not wait.
    virtual InputEvents poll() = 0;
    /// Returns when there are events, or after so long.
    virtual void wait(double seconds) = 0;
    virtual bool is_down(Key key) const = 0;
    virtual bool is_down(MouseButton button) const = 0;
    virtual glm::dvec2 cursor_px() const = 0;
    /// Hides the cursor and reports raw motion, for looking around; false gives the cursor back.
    virtual void capture_cursor(bool is_captured) = 0;
    virtual bool is_cursor_captured() const = 0;
    /// Device pixels for one logical pixel (high-density screens).
    virtual float content_scale() const = 0;
    virtual void swap() = 0;
    virtual bool should_close() const = 0;
    virtual void close() = 0;
    virtual void set_title(const std::string& title) = 0;
    /// Over the whole of the screen on which most of it lies, or back to where it was.
    virtual void set_full_screen(bool is_full) = 0;
    virtual bool is_full_screen() const = 0;
};

/// Opens a window. Throws hw::Error, Fault::device, when there is no display or no OpenGL 3.3.
std::unique_ptr<Window> make_window(const WindowOptions& options);

/// Whether a display seems to be there, without opening a window.
bool has_display();

}  // namespace hw
