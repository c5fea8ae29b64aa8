#include "program/pictures/world_shown.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hatchway/core/error.hpp"
#include "hatchway/core/log.hpp"
#include "program/option_rules.hpp"

namespace hw {

void add_show_arguments(CommandLine command, ShowArguments& arguments)
{
    command
        .add_option("--show", arguments.kinds,
                    "Lines that explain visibility from where the eye is: leaves, portals, pvs (boxes of what may be "
                    "seen, faint of what is hidden), wire; several by commas")
        .option_text("WHAT")
        .check(one_of({"leaves", "portals", "pvs", "wire"}))
        .delimiter(',')
        .one_value_each();
    command.add_flag("--leak", arguments.has_leaks, "Draw the ways out of a level that ought to be sealed");
}

std::string leak_text(const Leak& leak)
{
    const auto place = [](const glm::dvec3& p) { return fmt::format("({:.2f}, {:.2f}, {:.2f})", p.x, p.y, p.z); };
    if (leak.points_world.size() < 2)
        return fmt::format("leak: {} at {} lies outside", leak.from, place(leak.opening_world));
    std::string text = fmt::format("leak: from {} through an opening of {:.3g} m2 at {}", leak.from, leak.opening_m2,
                                   place(leak.opening_world));
    if (!leak.near_node.empty()) text += fmt::format(" near \"{}\"", leak.near_node);
    constexpr std::size_t kMostTold = 12;
    text += ", by way of";
    for (std::size_t i = 0; i < std::min(leak.points_world.size(), kMostTold); ++i)
        text += fmt::format(" {}", place(leak.points_world[i]));
    if (leak.points_world.size() > kMostTold)
        text += fmt::format(" and {} more points", leak.points_world.size() - kMostTold);
    return text;
}

LeakSearch told_leaks(const Level& level, const Scene& scene)
{
    const std::vector<InsidePlace> places = inside_places(level);
    if (places.empty())
        throw Error({.what = "nothing says where inside is",
                     .file = level.file.string(),
                     .pointer = "/start",
                     .expected = "a start, cameras or paths, to look for leaks from"});
    LeakSearch search = find_leaks(scene, level, places);
    for (const Leak& leak : search.leaks) log_warning(leak_text(leak));
    if (!search.is_complete)
        log_warning(level.file.string() +
                    ": too fine for the search for leaks: a part of what closes it is taken to be "
                    "open, so that what is named may be closed");
    else if (search.leaks.empty())
        log_info(level.file.string() + " is sealed");
    return search;
}

std::vector<OverlayLine> shown_lines(const Stage& stage, const ShowArguments& arguments, const std::vector<Leak>& leaks,
                                     const View& view, const glm::vec2& size_px)
{
    const auto has = [&](const char* kind) {
        return std::find(arguments.kinds.begin(), arguments.kinds.end(), kind) != arguments.kinds.end();
    };
    std::vector<WorldLine> lines;
    if (const Visibility* visibility = stage.visibility())
        lines = visibility_lines(stage.world(), *visibility,
                                 {.has_leaves = has("leaves"),
                                  .has_portals = has("portals"),
                                  .has_pvs = has("pvs"),
                                  .has_wire = has("wire")},
                                 view);
    const std::vector<WorldLine> out = leak_lines(leaks);
    lines.insert(lines.end(), out.begin(), out.end());
    return projected(lines, view, size_px);
}

}  // namespace hw
