#pragma once

#include <string>
#include <vector>

#include "hatchway/stage/stage.hpp"
#include "hatchway/walk/world_lines.hpp"
#include "program/command_line.hpp"

namespace hw {

/// How a command line asks for lines that explain a level's visibility.
struct ShowArguments {
    std::vector<std::string> kinds;
    bool has_leaks = false;
};

void add_show_arguments(CommandLine command, ShowArguments& arguments);

/// The ways out of a level, each told in a line of the log; one line when there is none, or when the search was not
/// complete. Throws hw::Error for a level that names no place to look from.
LeakSearch told_leaks(const Level& level, const Scene& scene);

/// A leak in words, without a line break.
std::string leak_text(const Leak& leak);

/// The lines that were asked for, as `view` shows them in a picture of `size_px` logical pixels; none of a visibility
/// that is not there yet.
std::vector<OverlayLine> shown_lines(const Stage& stage, const ShowArguments& arguments, const std::vector<Leak>& leaks,
                                     const View& view, const glm::vec2& size_px);

}  // namespace hw
