#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "hatchway/stage/stage.hpp"
#include "program/command_line.hpp"

namespace hw {

struct DeviceInfo;

/// Where more plugins are.
struct PluginArguments {
    std::vector<std::filesystem::path> folders;
    bool are_tried_anew = false;

    Trial trial() const { return are_tried_anew ? Trial::anew : Trial::if_new; }
};

/// What every subcommand that opens a level takes.
struct LevelArguments {
    std::filesystem::path file;
    std::vector<std::string> styles;
    PluginArguments plugins;
    bool without_pvs = false;
    bool without_baked_light = false;
    std::filesystem::path cache;  ///< Where compiled levels are kept; empty: in the user's own, or nowhere.
    bool without_cache = false;
};

/// What a command does with compiled levels where --cache does not say.
enum class CompiledUse : unsigned char {
    anew,           ///< Compiles, and keeps nothing.
    reused,         ///< Takes what is in the user's cache folder, or leaves it there.
    where_kept,     ///< Takes what is in the user's cache folder, or goes without.
    in_background,  ///< Takes what is in the user's cache folder, or leaves it there, without waiting.
};

void add_level_arguments(CommandLine command, LevelArguments& arguments);
void add_plugin_arguments(CommandLine command, PluginArguments& plugins);
void add_json_argument(CommandLine command, std::filesystem::path& json_file);

/// --cache alone, for commands that do not draw.
void add_cache_argument(CommandLine command, std::filesystem::path& cache);

/// Throws hw::Error if --cache names no folder, or none that can be made.
StageOptions stage_options(const LevelArguments& arguments, CompiledUse use = CompiledUse::anew);

/// What --pvs says, in the order of rising effort.
inline const std::vector<std::string> kPvsEfforts{"fast", "full", "exact"};
PvsEffort pvs_effort(const std::string& name);

/// "1280x720". Throws hw::Error unless both sides are in [1, limits::kMaxImageSide] and the picture has at
/// most limits::kMaxImagePixels.
glm::ivec2 parse_size(const std::string& text);

/// "X,Y,Z", three finite numbers. Throws hw::Error that names `option`.
glm::dvec3 parse_vector(const std::string& text, const std::string& option);

/// Throws hw::Error, Fault::device, when the device cannot draw pictures of that size. Asked before a level is opened.
void require_fits(const glm::ivec2& size_px, const DeviceInfo& device);

}  // namespace hw
