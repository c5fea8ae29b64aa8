#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <vector>

#include "gl/context.hpp"

namespace hw {

/// Keys by their place on a US keyboard: WASD stay together on other layouts.
enum class Key : std::uint8_t {
    unknown,
    a,
    b,
    c,
    d,
    e,
    f,
    g,
    h,
    i,
    j,
    k,
    l,
    m,
    n,
    o,
    p,
    q,
    r,
    s,
    t,
    u,
    v,
    w,
    x,
    y,
    z,
    digit_0,
    digit_1,
    digit_2,
    digit_3,
    digit_4,
    digit_5,
    digit_6,
    digit_7,
    digit_8,
    digit_9,
    f1,
    f2,
    f3,
    f4,
    f5,
    f6,
    f7,
    f8,
    f9,
    f10,
    f11,
    f12,
    up,
    down,
    left,
    right,
    page_up,
    page_down,
    home,
    end,
    space,
    enter,
    tab,
    escape,
    backspace,
    insert,
    del,
    shift,
    control,
    alt,
    super,
    plus,
    minus,
    comma,
    period,
    slash,
    grave,
};
inline constexpr int kKeyCount = static_cast<int>(Key::grave) + 1;

enum class MouseButton : std::uint8_t { left, right, middle };

struct KeyEvent {
    Key key = Key::unknown;
    bool is_down = false;
    bool is_repeat = false;
    bool with_shift = false;
    bool with_control = false;
    bool with_alt = false;
};

struct MouseEvent {
    MouseButton button = MouseButton::left;
    bool is_down = false;
    glm::dvec2 position_px{0.0};  ///< Window units from the top left corner.
};

/// What happened since the last poll, in order.
struct InputEvents {
    std::vector<KeyEvent> keys;
    std::vector<MouseEvent> buttons;
    glm::dvec2 motion{0.0};  ///< Mouse movement, right and down positive; raw counts while the cursor is captured.
    glm::dvec2 scroll{0.0};
    std::vector<std::string> dropped_files;
    bool was_resized = false;
    bool lost_focus = false;  ///< All keys count as released.
};

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
};

/// Opens a window. Throws hw::Error, Fault::device, when there is no display or no OpenGL 3.3.
std::unique_ptr<Window> make_window(const WindowOptions& options);

/// Whether a display seems to be there, without opening a window.
bool has_display();

}  // namespace hw
