#include "hatchway/walk/controls.hpp"

#include <gtest/gtest.h>

namespace {

using hw::Command;
using hw::CommandCall;
using hw::Key;

hw::InputEvents pressing(std::vector<hw::KeyEvent> keys)
{
    return {.keys = std::move(keys)};
}

hw::KeyEvent down(Key key)
{
    return {.key = key, .is_down = true};
}

/// Ctrl and a letter of a US keyboard.
hw::KeyEvent with_control(Key key)
{
    const auto letter = static_cast<char>('a' + static_cast<int>(key) - static_cast<int>(Key::a));
    return {.key = key, .is_down = true, .with_control = true, .letter = letter};
}

hw::KeyEvent up(Key key)
{
    return {.key = key, .is_down = false};
}

hw::ControlState captured()
{
    return {.is_mouse_captured = true};
}

std::vector<CommandCall> commands(const hw::ControlState& state, const hw::KeyEvent& event)
{
    return hw::controls_after(state, pressing({event})).commands;
}

}  // namespace

TEST(controls, a_held_key_moves_until_it_is_let_go)
{
    hw::Controls now = hw::controls_after({}, pressing({down(Key::w)}));
    EXPECT_EQ(now.player.forward, 1.0);
    now = hw::controls_after(now.state, {});
    EXPECT_EQ(now.player.forward, 1.0);
    now = hw::controls_after(now.state, pressing({up(Key::w)}));
    now = hw::controls_after(now.state, {});
    EXPECT_EQ(now.player.forward, 0.0);
}

TEST(controls, a_tap_within_one_frame_is_not_lost)
{
    const hw::Controls now = hw::controls_after({}, pressing({down(Key::space), up(Key::space)}));
    EXPECT_TRUE(now.player.wants_jump);
    EXPECT_FALSE(hw::controls_after(now.state, {}).player.wants_jump);
}

TEST(controls, arrows_walk_and_turn)
{
    EXPECT_EQ(hw::controls_after({}, pressing({down(Key::up)})).player.forward, 1.0);
    EXPECT_EQ(hw::controls_after({}, pressing({down(Key::left)})).player.turn_left, 1.0);
    EXPECT_EQ(hw::controls_after({}, pressing({down(Key::left), down(Key::right)})).player.turn_left, 0.0);
}

TEST(controls, losing_the_focus_lets_go_of_everything)
{
    const hw::Controls before = hw::controls_after(captured(), pressing({down(Key::w)}));
    hw::InputEvents events;
    events.lost_focus = true;
    const hw::Controls now = hw::controls_after(before.state, events);
    EXPECT_TRUE(now.state.held.none());
    EXPECT_FALSE(now.state.is_mouse_captured);
    EXPECT_EQ(now.commands, (std::vector<CommandCall>{{Command::release_mouse}}));
}

TEST(controls, saving_with_control_s_does_not_walk_backwards)
{
    const hw::Controls now = hw::controls_after({}, pressing({with_control(Key::s)}));
    EXPECT_EQ(now.player.forward, 0.0);
    EXPECT_EQ(now.commands, (std::vector<CommandCall>{{Command::save_level}}));
}

TEST(controls, the_mouse_turns_by_its_way_and_not_by_time)
{
    hw::InputEvents events;
    events.motion = {100.0, -50.0};
    const hw::PlayerInput whole = hw::controls_after(captured(), events).player;
    EXPECT_LT(whole.look_left_rad, 0.0);
    EXPECT_GT(whole.look_up_rad, 0.0);
    events.motion = {50.0, -25.0};
    const hw::PlayerInput half = hw::controls_after(captured(), events).player;
    EXPECT_DOUBLE_EQ(2.0 * half.look_left_rad, whole.look_left_rad);
    EXPECT_DOUBLE_EQ(2.0 * half.look_up_rad, whole.look_up_rad);
}

TEST(controls, a_free_mouse_does_not_turn_the_head)
{
    hw::InputEvents events;
    events.motion = {100.0, 0.0};
    EXPECT_EQ(hw::controls_after({}, events).player.look_left_rad, 0.0);
}

TEST(controls, the_click_that_takes_the_mouse_does_not_turn_the_head)
{
    hw::InputEvents events;
    events.buttons = {{.button = hw::MouseButton::left, .is_down = true}};
    events.motion = {300.0, 0.0};
    const hw::Controls now = hw::controls_after({}, events);
    EXPECT_TRUE(now.state.is_mouse_captured);
    EXPECT_EQ(now.commands, (std::vector<CommandCall>{{Command::capture_mouse}}));
    EXPECT_EQ(now.player.look_left_rad, 0.0);
}

TEST(controls, escape_gives_the_mouse_back_and_never_quits)
{
    const hw::Controls first = hw::controls_after(captured(), pressing({down(Key::escape)}));
    EXPECT_FALSE(first.state.is_mouse_captured);
    EXPECT_EQ(first.commands, (std::vector<CommandCall>{{Command::release_mouse}}));
    EXPECT_TRUE(commands(first.state, down(Key::escape)).empty());
}

TEST(controls, q_quits_only_while_the_mouse_is_free)
{
    EXPECT_EQ(commands({}, down(Key::q)), (std::vector<CommandCall>{{Command::quit}}));
    EXPECT_TRUE(commands(captured(), down(Key::q)).empty());
    EXPECT_EQ(commands(captured(), with_control(Key::q)), (std::vector<CommandCall>{{Command::quit}}));
}

TEST(controls, digits_name_cameras)
{
    EXPECT_EQ(commands({}, down(Key::digit_1)), (std::vector<CommandCall>{{Command::go_to_camera, 1}}));
    EXPECT_EQ(commands({}, down(Key::digit_9)), (std::vector<CommandCall>{{Command::go_to_camera, 9}}));
    EXPECT_EQ(commands({}, down(Key::digit_0)), (std::vector<CommandCall>{{Command::go_to_camera, 0}}));
}

TEST(controls, tab_cycles_but_the_desktops_alt_tab_does_not)
{
    EXPECT_EQ(commands({}, down(Key::tab)), (std::vector<CommandCall>{{Command::next_style}}));
    EXPECT_EQ(commands({}, {.key = Key::tab, .is_down = true, .with_shift = true}),
              (std::vector<CommandCall>{{Command::previous_style}}));
    EXPECT_TRUE(commands({}, {.key = Key::tab, .is_down = true, .with_alt = true}).empty());
}

TEST(controls, undo_and_redo_have_their_usual_keys)
{
    EXPECT_EQ(commands({}, with_control(Key::z)), (std::vector<CommandCall>{{Command::undo}}));
    EXPECT_EQ(commands({}, with_control(Key::y)), (std::vector<CommandCall>{{Command::redo}}));
    hw::KeyEvent with_shift = with_control(Key::z);
    with_shift.with_shift = true;
    EXPECT_EQ(commands({}, with_shift), (std::vector<CommandCall>{{Command::redo}}));
}

TEST(controls, shortcuts_follow_the_printed_letter_and_walking_the_place_of_the_key)
{
    hw::KeyEvent german_z = with_control(Key::y);
    german_z.letter = 'z';
    EXPECT_EQ(commands({}, german_z), (std::vector<CommandCall>{{Command::undo}}));
    const hw::KeyEvent french_z{.key = Key::w, .is_down = true, .letter = 'z'};
    EXPECT_EQ(hw::controls_after({}, pressing({french_z})).player.forward, 1.0);
}

TEST(controls, a_key_that_repeats_calls_its_command_once)
{
    EXPECT_TRUE(commands({}, {.key = Key::tab, .is_down = true, .is_repeat = true}).empty());
}

TEST(controls, the_wheel_sets_the_speed_within_limits)
{
    hw::InputEvents events;
    events.scroll = {0.0, 2.0};
    EXPECT_GT(hw::controls_after({}, events).player.speed_factor, 1.3);
    events.scroll = {0.0, -1e6};
    EXPECT_EQ(hw::controls_after({}, events).player.speed_factor, 0.1);
    events.scroll = {0.0, 1e6};
    EXPECT_EQ(hw::controls_after({}, events).player.speed_factor, 10.0);
}

TEST(key_help, names_every_key_of_the_manual)
{
    std::string all;
    for (const hw::KeyHelp& line : hw::key_help()) all += line.keys + ' ';
    for (const char* key : {"W A S D", "Shift", "Space", "Tab", "Ctrl+S", "Ctrl+Z", "F12", "F1", "F3", "Ctrl+Q"})
        EXPECT_NE(all.find(key), std::string::npos) << key;
}

TEST(controls, h_hides_and_alt_h_shows_all_as_in_blender)
{
    EXPECT_EQ(commands({}, down(Key::h)), std::vector{CommandCall{Command::hide}});
    const hw::KeyEvent alt_h{.key = Key::h, .is_down = true, .with_alt = true, .letter = 'h'};
    EXPECT_EQ(commands(captured(), alt_h), std::vector{CommandCall{Command::show_all}});
    EXPECT_EQ(commands({}, down(Key::f1)), std::vector{CommandCall{Command::toggle_help}});
}

TEST(controls, escape_stops_a_playing_path_and_only_then_frees_the_mouse)
{
    hw::ControlState state = captured();
    state.is_path_playing = true;
    const hw::Controls now = hw::controls_after(state, pressing({down(Key::escape), down(Key::escape)}));
    EXPECT_EQ(now.commands, (std::vector{CommandCall{Command::stop_path}, CommandCall{Command::release_mouse}}));
    state = {.is_path_playing = true};
    EXPECT_EQ(commands(state, down(Key::escape)), std::vector{CommandCall{Command::stop_path}});
}
