#include <fmt/format.h>

#include "hatchway/core/error.hpp"
#include "program/arguments.hpp"
#include "program/commands.hpp"
#include "program/option_rules.hpp"
#include "program/pictures/walk_session.hpp"

namespace hw {
namespace {

struct WalkArguments {
    WalkOptions options;
    std::string size = "1280x720";
};

void check_arguments(const WalkArguments& arguments)
{
    parse_size(arguments.size);
    const WalkOptions& options = arguments.options;
    // A wrong level is told before a window opens, and with the same words as everywhere.
    read_level_with(options.level.file, options.level.styles);
    if (!has_display())
        throw Error({.what = "walk needs a window, and there is no display (DISPLAY and WAYLAND_DISPLAY are not set)",
                     .expected = "a display; without one, hatchway render draws pictures",
                     .fault = Fault::device});
}

void walk(const WalkArguments& arguments)
{
    check_arguments(arguments);
    const auto window = make_window({.size = parse_size(arguments.size)});
    WalkSession(*window, arguments.options).run();
}

std::string keys_text()
{
    std::string text = "Keys:\n";
    for (const KeyHelp& line : key_help()) text += fmt::format("  {:<16}{}\n", line.keys, line.effect);
    return text;
}

}  // namespace

void add_walk_command(CommandLine app)
{
    auto arguments = std::make_shared<WalkArguments>();
    CommandLine command = app.add_subcommand("walk", "Walks through a level in a window");
    add_level_arguments(command, arguments->options.level);
    command.add_option("--camera", arguments->options.camera, "Start at a camera of the level or the model")
        .option_text("NAME");
    add_show_arguments(command, arguments->options.show);
    command.add_option("--size", arguments->size, "Size of the window, 1280x720").option_text("WxH");
    command
        .add_option("--fps", arguments->options.target_fps,
                    "Frames a second to hold by fewer samples and pixels: 60, or 30 on a software renderer")
        .option_text("F")
        .check(number_in(1.0, 1000.0));
    command.add_option("--samples", arguments->options.samples, "Always 1 or 4 samples, whatever the frame rate")
        .option_text("N")
        .check(one_of({"1", "4"}));
    command.footer(keys_text());
    command.callback([arguments] { walk(*arguments); });
}

}  // namespace hw
