#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace hw {

// clang-format off
/// Keys by their place on a US keyboard: WASD stay together on other layouts.
enum class Key : std::uint8_t {
    unknown,
    a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z,
    digit_0, digit_1, digit_2, digit_3, digit_4, digit_5, digit_6, digit_7, digit_8, digit_9,
    f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12,
    up, down, left, right, page_up, page_down, home, end, space, enter, tab, escape, backspace, insert, del,
    shift, control, alt, super, plus, minus, comma, period, slash, grave,
};
// clang-format on
inline constexpr int kKeyCount = static_cast<int>(Key::grave) + 1;

enum class MouseButton : std::uint8_t { left, right, middle };

struct KeyEvent {
    Key key = Key::unknown;
    bool is_down = false;
    bool is_repeat = false;
    bool with_shift = false;
    bool with_control = false;
    bool with_alt = false;
    char letter = '\0';  ///< 'a' to 'z' as the user's layout prints it on this key; 0 on other keys. For Ctrl+Z.
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
    bool needs_redraw = false;  ///< The window has another size, or something that covered it went away.
    bool lost_focus = false;    ///< All keys count as released.
};

}  // namespace hw
