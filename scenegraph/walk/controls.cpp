#include "hatchway/walk/controls.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hw {
namespace {

constexpr double kRadiansPerCount = 0.0022;  // an eighth of a degree: a hand's width turns by about 90 degrees
constexpr double kWheelFactor = 1.15;
constexpr double kSlowest = 0.1, kFastest = 10.0;

std::optional<int> digit_of(Key key)
{
    if (key < Key::digit_0 || key > Key::digit_9) return std::nullopt;
    return static_cast<int>(key) - static_cast<int>(Key::digit_0);
}

/// By the printed letter, as everywhere else on the user's desktop: on a German keyboard Z lies where Y does on others.
std::optional<CommandCall> control_command(const KeyEvent& event)
{
    switch (event.letter) {
        case 's':
            return CommandCall{Command::save_level};
        case 'z':
            return CommandCall{event.with_shift ? Command::redo : Command::undo};
        case 'y':
            return CommandCall{Command::redo};
        case 'q':
            return CommandCall{Command::quit};
        default:
            return std::nullopt;
    }
}

/// Q alone quits only while the mouse is free: it lies beside W and A, where a walking hand hits it by mistake.
std::optional<CommandCall> command_of(const KeyEvent& event, const ControlState& state)
{
    if (event.with_control) return control_command(event);
    if (event.with_alt && event.key == Key::h) return CommandCall{Command::show_all};
    if (event.with_alt) return std::nullopt;  // Alt+Tab belongs to the desktop
    if (const auto digit = digit_of(event.key)) return CommandCall{Command::go_to_camera, *digit};
    switch (event.key) {
        case Key::escape:
            return CommandCall{state.is_path_playing ? Command::stop_path : Command::release_mouse};
        case Key::q:
            return state.is_mouse_captured ? std::nullopt : std::optional(CommandCall{Command::quit});
        case Key::f:
            return CommandCall{Command::toggle_flight};
        case Key::p:
            return CommandCall{Command::play_path};
        case Key::tab:
            return CommandCall{event.with_shift ? Command::previous_style : Command::next_style};
        case Key::f12:
            return CommandCall{Command::save_picture};
        case Key::f3:
            return CommandCall{Command::toggle_statistics};
        case Key::f11:
            return CommandCall{Command::toggle_full_screen};
        case Key::h:
            return CommandCall{Command::hide};
        case Key::f1:
            return CommandCall{Command::toggle_help};
        default:
            return std::nullopt;
    }
}

using Held = std::bitset<kKeyCount>;

double axis(const Held& held, std::initializer_list<Key> plus, std::initializer_list<Key> minus)
{
    const auto any = [&](std::initializer_list<Key> keys) {
        return std::any_of(keys.begin(), keys.end(), [&](Key key) { return held[static_cast<std::size_t>(key)]; });
    };
    return (any(plus) ? 1.0 : 0.0) - (any(minus) ? 1.0 : 0.0);
}

PlayerInput player_input(const Held& held, const InputEvents& events, const ControlState& state)
{
    PlayerInput input;
    input.forward = axis(held, {Key::w, Key::up}, {Key::s, Key::down});
    input.right = axis(held, {Key::d}, {Key::a});
    input.up = axis(held, {Key::space}, {Key::c});
    input.turn_left = axis(held, {Key::left}, {Key::right});
    input.turn_up = axis(held, {Key::page_up}, {Key::page_down});
    input.is_fast = held[static_cast<std::size_t>(Key::shift)];
    input.wants_jump = held[static_cast<std::size_t>(Key::space)];
    input.speed_factor = state.speed_factor;
    if (state.is_mouse_captured) {
        input.look_left_rad = -events.motion.x * kRadiansPerCount;
        input.look_up_rad = -events.motion.y * kRadiansPerCount;
    }
    return input;
}

/// Which keys are held after the events, and in `pressed` which were at any moment of the frame.
Held held_after(Held held, const InputEvents& events, Held& pressed)
{
    pressed = held;
    for (const KeyEvent& event : events.keys) {
        const auto index = static_cast<std::size_t>(event.key);
        const bool is_shortcut = event.with_control || event.with_alt;
        if (!event.is_down)
            held.reset(index);
        else if (!is_shortcut && !event.is_repeat)
            held.set(index);
        pressed |= held;
    }
    if (events.lost_focus) held.reset();
    return held;
}

}  // namespace

Controls controls_after(const ControlState& state, const InputEvents& events)
{
    Controls result{.state = state};
    Held pressed;
    result.state.held = held_after(state.held, events, pressed);
    result.state.speed_factor =
        std::clamp(state.speed_factor * std::pow(kWheelFactor, events.scroll.y), kSlowest, kFastest);
    for (const KeyEvent& event : events.keys) {
        if (!event.is_down || event.is_repeat) continue;
        const auto call = command_of(event, result.state);
        if (!call) continue;
        if (call->command == Command::release_mouse && !result.state.is_mouse_captured) continue;
        if (call->command == Command::release_mouse) result.state.is_mouse_captured = false;
        if (call->command == Command::stop_path) result.state.is_path_playing = false;
        result.commands.push_back(*call);
    }
    const bool is_clicked = std::any_of(events.buttons.begin(), events.buttons.end(), [](const MouseEvent& event) {
        return event.is_down && event.button == MouseButton::left;
    });
    if (is_clicked && !state.is_mouse_captured) {
        result.state.is_mouse_captured = true;
        result.commands.push_back({Command::capture_mouse});
    }
    if (events.lost_focus && result.state.is_mouse_captured) {
        result.state.is_mouse_captured = false;
        result.commands.push_back({Command::release_mouse});
    }
    // The frame in which the mouse is captured still reports the cursor's way there: not a turn of the head.
    const bool was_captured = state.is_mouse_captured && result.state.is_mouse_captured;
    ControlState during = result.state;
    during.is_mouse_captured = was_captured;
    result.player = player_input(pressed, events, during);
    return result;
}

const std::vector<KeyHelp>& key_help()
{
    static const std::vector<KeyHelp> help{
        {"W A S D", "walk"},
        {"Up, Down", "walk; Left, Right turn; Page Up, Page Down look up and down"},
        {"Mouse", "look around; a click takes the mouse, Esc gives it back"},
        {"Shift", "fast; the wheel sets the speed"},
        {"Space", "jump; flying: up, and C down"},
        {"F", "fly or walk"},
        {"1 ... 9, 0", "the level's cameras, the start"},
        {"P", "play the level's path; Esc or any move stops it"},
        {"Tab, Shift+Tab", "next or previous style of the object under the cross-hair"},
        {"H, Alt+H", "hide the object under the cross-hair; show all that is hidden"},
        {"Ctrl+Z, Ctrl+Y", "undo, redo (also Ctrl+Shift+Z)"},
        {"Ctrl+S", "save styles and what is hidden into the level file"},
        {"F11", "full screen, and back"},
        {"F12", "save this picture beside the level"},
        {"F3", "statistics"},
        {"F1", "this help"},
        {"Ctrl+Q", "quit; Q does while the mouse is free"},
    };
    return help;
}

}  // namespace hw
