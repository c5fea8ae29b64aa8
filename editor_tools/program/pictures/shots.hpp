#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hatchway/render/view/camera_view.hpp"
#include "hatchway/stage/stage.hpp"
#include "program/command_line.hpp"

namespace hw {

/// How a command line says from where to look.
struct ShotArguments {
    std::string camera;
    std::string eye;
    std::string target;
    std::optional<double> fov_deg;
    std::optional<double> ortho_m;
    std::optional<double> roll_deg;
    std::string path;
    std::optional<int> frames;
    double time_s = 0.0;
};

/// One picture: a camera at a time.
struct Shot {
    CameraPlace camera;
    double time_s = 0.0;
};

/// The paths that every level has: its own of that name, else once around the scene.
inline constexpr const char* kTour = "tour";
inline constexpr const char* kTurntable = "turntable";

/// --fov-deg, --ortho and --roll-deg.
void add_projection_arguments(CommandLine command, ShotArguments& arguments);

void add_shot_arguments(CommandLine command, ShotArguments& arguments);

/// Checks what can be checked before a level is opened. Throws hw::Error.
void check_shot_arguments(const ShotArguments& arguments);

/// The pictures to make: of the camera, the eye and target, or the path that the arguments name; else of one camera
/// that sees the whole scene. Throws hw::Error that lists the cameras or paths that exist.
std::vector<Shot> shots_of(const ShotArguments& arguments, const Level& level, const Scene& scene, double aspect);

/// Of a parallel projection: warns where it would show what lies too deep to be drawn (is_beyond()).
void warn_of_what_is_beyond(const View& view, std::span<const Box> boxes_world);

}  // namespace hw
