#include "program/pictures/shots.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hatchway/core/error.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/stage/whole_scene.hpp"
#include "hatchway/world/camera_path.hpp"
#include "program/arguments.hpp"
#include "program/option_rules.hpp"
#include "program/pictures/walk_cameras.hpp"

namespace hw {
namespace {

constexpr double kDefaultFovDeg = 60.0;

/// What the command line says of the projection goes before what the camera says.
void project(CameraPlace& camera, const ShotArguments& arguments)
{
    if (arguments.fov_deg) camera.fov_deg = *arguments.fov_deg;
    if (arguments.fov_deg) camera.orthographic_height_m.reset();
    if (arguments.roll_deg) camera.roll_deg = *arguments.roll_deg;
    if (arguments.ortho_m) camera.orthographic_height_m = arguments.ortho_m;
}

CameraPlace named_camera(const std::string& name, const Level& level, const Scene& scene)
{
    return camera_place(camera_named(name, level, scene, "--eye and --target: this level has no cameras"));
}

CameraPath named_path(const std::string& name, const Level& level, const Scene& scene, double aspect)
{
    if (const CameraPath* path = find_named(level.paths, name)) return *path;
    if (name == kTour) log_info("the level has no path \"tour\": going once around the scene");
    if (name == kTour || name == kTurntable) return turntable(scene, aspect);

    std::vector<std::string> names;
    for (const CameraPath& path : level.paths) names.push_back(path.name);
    names.emplace_back(kTurntable);
    throw Error({.what = fmt::format("--path: there is no path \"{}\"", name),
                 .file = level.file.string(),
                 .expected = fmt::format("one of: {}", fmt::join(names, ", "))});
}

std::vector<Shot> shots_along(const CameraPath& path, const ShotArguments& arguments)
{
    const int count = arguments.frames.value_or(path_frame_count(path));
    const double first_s = path.keys.front().t_s;
    const double span_s = path.keys.back().t_s - first_s;
    std::vector<Shot> shots;
    for (int frame = 0; frame < count; ++frame) {
        const double even_s = first_s + (count > 1 ? span_s * frame / (count - 1) : 0.0);
        const double time_s = arguments.frames ? even_s : path_frame_time(path, frame);
        shots.push_back({camera_place(camera_at(path, time_s)), time_s});
        project(shots.back().camera, arguments);
    }
    return shots;
}

}  // namespace

void add_projection_arguments(CommandLine command, ShotArguments& arguments)
{
    command.add_option("--fov-deg", arguments.fov_deg, "Vertical field of view")
        .option_text("F")
        .check(number_in(1.0, 170.0));
    command
        .add_option("--ortho", arguments.ortho_m, "A parallel projection, so many metres high, in place of --fov-deg")
        .option_text("HEIGHT_M")
        .check(number_in(1e-6, 1e9));
    command
        .add_option("--roll-deg", arguments.roll_deg,
                    "Turns the camera about its line of sight, counter-clockwise as it looks")
        .option_text("R")
        .check(number_in(-360.0, 360.0));
}

void add_shot_arguments(CommandLine command, ShotArguments& arguments)
{
    command.add_option("--camera", arguments.camera, "A camera of the level or the model").option_text("NAME");
    command.add_option("--eye", arguments.eye, "Where to look from, metres, y up").option_text("X,Y,Z");
    command.add_option("--target", arguments.target, "What to look at").option_text("X,Y,Z");
    add_projection_arguments(command, arguments);
    command.add_option("--path", arguments.path, "A camera path of the level, or turntable").option_text("NAME");
    command.add_option("--frames", arguments.frames, "That many pictures, spread evenly over the path")
        .option_text("N")
        .check(whole_number_in(1, 100'000));
    command.add_option("--time-s", arguments.time_s, "The time that the styles see, without a path")
        .option_text("T")
        .check(number_in(-1e9, 1e9));
}

void check_shot_arguments(const ShotArguments& arguments)
{
    if (arguments.fov_deg && arguments.ortho_m)
        throw Error({.what = "both --fov-deg and --ortho", .expected = "one of them"});
    const int ways = !arguments.camera.empty() + !arguments.eye.empty() + !arguments.path.empty();
    if (ways > 1)
        throw Error({.what = "more than one of --camera, --eye and --path", .expected = "one of them, or none"});
    if (arguments.eye.empty() != arguments.target.empty())
        throw Error({.what = arguments.eye.empty() ? "--target without --eye" : "--eye without --target",
                     .expected = "both or none"});
    if (!arguments.eye.empty() && parse_vector(arguments.eye, "--eye") == parse_vector(arguments.target, "--target"))
        throw Error({.what = "--eye and --target are the same place", .expected = "two places"});
    if (arguments.frames && arguments.path.empty())
        throw Error({.what = "--frames without --path", .expected = "a path to spread them over"});
}

std::vector<Shot> shots_of(const ShotArguments& arguments, const Level& level, const Scene& scene, double aspect)
{
    if (!arguments.path.empty()) return shots_along(named_path(arguments.path, level, scene, aspect), arguments);
    Shot shot{{}, arguments.time_s};
    if (!arguments.camera.empty())
        shot.camera = named_camera(arguments.camera, level, scene);
    else if (!arguments.eye.empty())
        shot.camera = {
            parse_vector(arguments.eye, "--eye"), parse_vector(arguments.target, "--target"), kDefaultFovDeg, {}};
    else
        shot.camera = whole_scene_camera(scene, aspect);
    project(shot.camera, arguments);
    return {shot};
}

void warn_of_what_is_beyond(const View& view, std::span<const Box> boxes_world)
{
    const auto count = std::ranges::count_if(boxes_world, [&](const Box& box) { return is_beyond(view, box); });
    if (count > 0)
        log_warning(
            fmt::format("{} {} more than 10,000 times as far behind the nearest thing as the parallel view is high, or "
                        "{} there: not "
                        "drawn there",
                        count, count == 1 ? "thing lies" : "things lie", count == 1 ? "reaches" : "reach"));
}

}  // namespace hw
