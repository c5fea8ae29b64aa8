#include "program/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "hatchway/core/error.hpp"
#include "hatchway/core/limits.hpp"
#include "hatchway/gl/context.hpp"
#include "hatchway/io/model/import.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace fs = std::filesystem;

void add_level_arguments(CommandLine command, LevelArguments& arguments)
{
    command.add_option("level", arguments.file, fmt::format("A level file (.json) or a bare model ({})", kModelFormats))
        .required()
        .option_text("LEVEL|MODEL");
    command
        .add_option("--style", arguments.styles,
                    "Draw the nodes of a path glob in a style: '*=pen_and_ink'; repeatable")
        .option_text("GLOB=STYLE")
        .one_value_each();
    add_plugin_arguments(command, arguments.plugins);
    command.add_flag("--no-pvs", arguments.without_pvs, "Draw everything in the frustum");
    command.add_flag("--no-baked-light", arguments.without_baked_light, "Leave the lightmap beside the level alone");
    add_cache_argument(command, arguments.cache);
    command.add_flag("--no-cache", arguments.without_cache, "Take no compiled level that is kept, and keep none");
}

void add_cache_argument(CommandLine command, fs::path& cache)
{
    command.add_option("--cache", cache, "Keep compiled levels in this folder and find them there").option_text("DIR");
}

void add_plugin_arguments(CommandLine command, PluginArguments& plugins)
{
    command
        .add_option("--plugin-dir", plugins.folders,
                    "A folder with more plugins; repeatable. Each is tried once in a process of its own; one that "
                    "crashes is left out")
        .option_text("DIR")
        .one_value_each();
    command.add_flag("--retry-plugins", plugins.are_tried_anew,
                     "Try the plugins of --plugin-dir again, also those that were left out");
}

void add_json_argument(CommandLine command, fs::path& json_file)
{
    command.add_option("--json", json_file, "Write the result as JSON").option_text("FILE");
}

static VisibilityUse visibility_use(CompiledUse use)
{
    if (use == CompiledUse::where_kept) return VisibilityUse::where_kept;
    return use == CompiledUse::in_background ? VisibilityUse::in_background : VisibilityUse::compiled;
}

StageOptions stage_options(const LevelArguments& arguments, CompiledUse use)
{
    std::optional<CompiledCache> cache;
    if (!arguments.cache.empty()) require_writable_folder(arguments.cache, "--cache");
    if (!arguments.without_cache && (use != CompiledUse::anew || !arguments.cache.empty()))
        cache = CompiledCache{arguments.cache};
    return {.file = arguments.file,
            .style_overrides = arguments.styles,
            .plugin_dirs = arguments.plugins.folders,
            .plugin_trial = arguments.plugins.trial(),
            .visibility_use = arguments.without_pvs ? VisibilityUse::none : visibility_use(use),
            .visibility = {},
            .baked_light = arguments.without_baked_light ? BakedLight::unwanted : BakedLight::if_there,
            .cache = std::move(cache)};
}

PvsEffort pvs_effort(const std::string& name)
{
    return name == kPvsEfforts[0] ? PvsEffort::fast : name == kPvsEfforts[1] ? PvsEffort::full : PvsEffort::exact;
}

glm::ivec2 parse_size(const std::string& text)
{
    glm::ivec2 size(0);
    const char* end = text.data() + text.size();
    const auto [sign, width_status] = std::from_chars(text.data(), end, size.x);
    const bool has_sign = width_status == std::errc() && sign != end && *sign == 'x';
    const auto [stop, height_status] = std::from_chars(has_sign ? sign + 1 : end, end, size.y);
    const auto is_side = [](int side) { return side >= 1 && side <= limits::kMaxImageSide; };
    if (!has_sign || height_status != std::errc() || stop != end || !is_side(size.x) || !is_side(size.y))
        throw Error(
            {.what = "--size " + text,
             .expected = "WxH, each from 1 to " + std::to_string(limits::kMaxImageSide) + ", such as 1280x720"});
    const auto pixels = static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
    if (pixels > limits::kMaxImagePixels)
        throw Error({.what = fmt::format("--size {}: {} pixels", text, pixels),
                     .expected = fmt::format("at most {} pixels", limits::kMaxImagePixels)});
    return size;
}

glm::dvec3 parse_vector(const std::string& text, const std::string& option)
{
    glm::dvec3 vector(0.0);
    const char* at = text.data();
    const char* end = at + text.size();
    bool is_good = true;
    for (int i = 0; i < 3 && is_good; ++i) {
        const auto [stop, status] = std::from_chars(at, end, vector[i]);
        const bool is_last = i == 2;
        is_good = status == std::errc() && std::abs(vector[i]) <= limits::kMaxCoordinate &&
                  (is_last ? stop == end : stop != end && *stop == ',');
        at = is_last ? stop : stop + 1;
    }
    if (!is_good) throw Error({.what = option + " " + text, .expected = "X,Y,Z, three numbers, such as 0,1.7,8"});
    return vector;
}

void require_fits(const glm::ivec2& size_px, const DeviceInfo& device)
{
    if (std::max(size_px.x, size_px.y) <= device.max_texture_side) return;
    throw Error({.what = fmt::format("--size {}x{}", size_px.x, size_px.y),
                 .expected = fmt::format("at most {} a side on this device", device.max_texture_side),
                 .fault = Fault::device});
}

}  // namespace hw
