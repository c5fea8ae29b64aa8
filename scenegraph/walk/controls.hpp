#pragma once

#include <bitset>
#include <string>
#include <vector>

#include "hatchway/gl/window.hpp"
#include "hatchway/walk/player.hpp"

namespace hw {

/// What a key asks the program to do, once for each press.
enum class Command : std::uint8_t {
    quit,
    capture_mouse,
    release_mouse,
    toggle_flight,
    go_to_camera,  ///< `number` 1..9: cameras in the order of the level; 0: the start.
    next_style,    ///< Of the object under the cross-hair.
    previous_style,
    hide,      ///< The object under the cross-hair.
    show_all,  ///< What is hidden.
    save_level,
    undo,
    redo,
    save_picture,
    toggle_help,
    toggle_statistics,
    toggle_full_screen,
    play_path,
    stop_path,
};

struct CommandCall {
    Command command = Command::quit;
    int number = 0;

    bool operator==(const CommandCall&) const = default;
};

/// What is held down from one frame to the next. A fresh one holds nothing and leaves the mouse to the desktop.
struct ControlState {
    std::bitset<kKeyCount> held;  ///< Keys that move: those pressed together with Ctrl or Alt are commands, not moves.
    bool is_mouse_captured = false;
    bool is_path_playing = false;  ///< Set by the owner: Esc then stops the path.
    double speed_factor = 1.0;     ///< Set with the wheel, in [0.1, 10].
};

/// One frame's events, translated.
struct Controls {
    ControlState state;
    PlayerInput player;
    std::vector<CommandCall> commands;  ///< In the order of the keys.
};

/// Translates what happened since the last frame. A key that was pressed and let go within one frame counts as held for
/// that frame. Losing the focus lets go of everything. A function of its arguments alone.
Controls controls_after(const ControlState& state, const InputEvents& events);

/// A key and what it does, for the help on screen and in the manual.
struct KeyHelp {
    std::string keys;
    std::string effect;
};

/// The whole list, from which help is printed.
const std::vector<KeyHelp>& key_help();

}  // namespace hw
