// Ink maps level by level: width of strokes, tone and contrast, of the map as it was made, of one made anew from the
// pixels of its finest level, and of what minimum and box filtering make of that level.
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <map>

#include "hatchway/core/error.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/io/images/map_file.hpp"
#include "hatchway/maps/bitmap_strokes.hpp"
#include "hatchway/maps/ink_map.hpp"
#include "measure/hatching/ink_level.hpp"
#include "measure/measure_result.hpp"
#include "measure/measures.hpp"
#include "measure/no_value.hpp"
#include "program/arguments.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

struct InkMeasureArguments {
    std::vector<std::filesystem::path> maps;
    MeasureResult result;
};

/// A map as `hatchway map ink` makes it of a drawing in pixels.
MapLevels from_pixels(const Pixels& drawing, const MapLevels& like)
{
    std::vector<MapStroke> strokes = strokes_of_bitmap(drawing);
    rank_evenly(strokes);
    const double pen_texels = ink_level_figures(drawing).stroke_texels;
    return make_ink_map(strokes, {.width_texels = drawing.width,
                                  .height_texels = drawing.height,
                                  .pen_texels = pen_texels > 0.0 ? pen_texels : InkMapDesc{}.pen_texels,
                                  .size_m = like.size_m})
        .map;
}

double relative(double value, double to)
{
    return measure::share_of(value, to) - 1.0;
}

/// Adds the rows of a map. Gives the largest step of tone from level 1 on, relative: level 0 is as it was drawn.
double add_rows(JsonValue& rows, const std::string& name, const std::string& filter, const MapLevels& map)
{
    double largest_step = measure::kNoValue;
    const InkLevelFigures finest = ink_level_figures(map.levels.front());
    if (finest.tone <= 0.0) throw Error({.what = name + ": no ink in its finest level", .expected = "a drawing"});
    InkLevelFigures above = finest;
    for (std::size_t i = 0; i < map.levels.size(); ++i) {
        const InkLevelFigures level = ink_level_figures(map.levels[i]);
        const double tone_error = relative(level.tone, finest.tone), tone_step = relative(level.tone, above.tone);
        above = level;
        if (i >= 2) largest_step = std::fmax(largest_step, std::abs(tone_step));
        const bool has_strokes = level.stroke_texels > 0.0 && finest.stroke_texels > 0.0;
        const double stroke_texels = has_strokes ? level.stroke_texels : measure::kNoValue;
        const double width_error = relative(stroke_texels, finest.stroke_texels);
        const double kept = measure::share_of(level.contrast, finest.contrast);
        const std::string stroke = has_strokes ? fmt::format("{:>10.2f}{:>+9.0f} %", stroke_texels, 100.0 * width_error)
                                               : fmt::format("{:>21}", "none");
        print_line(fmt::format("{:<20}{:<12}{:>6}{:>8}{}{:>9.3f}{:>+7.0f} %{:>+7.0f} %{:>9.2f}", name, filter, i,
                               map.levels[i].width, stroke, level.tone, 100.0 * tone_error, 100.0 * tone_step, kept));
        rows.push(JsonValue::object()
                      .set("map", name)
                      .set("filter", filter)
                      .set("level", static_cast<std::uint64_t>(i))
                      .set("width_texels", map.levels[i].width)
                      .set("stroke_texels", stroke_texels)
                      .set("stroke_error", width_error)
                      .set("tone", level.tone)
                      .set("tone_error", tone_error)
                      .set("tone_step", tone_step)
                      .set("contrast_kept", kept));
    }
    return largest_step;
}

/// The filters that are compared, each as it makes levels of a map.
const std::vector<std::pair<const char*, std::function<MapLevels(const MapLevels&)>>>& filters()
{
    static const std::vector<std::pair<const char*, std::function<MapLevels(const MapLevels&)>>> all{
        {"as made", [](const MapLevels& map) { return map; }},
        {"from pixels", [](const MapLevels& map) { return from_pixels(map.levels.front(), map); }},
        {"minimum", [](const MapLevels& map) { return filtered_by_minimum(map.levels.front(), map.size_m); }},
        {"box", [](const MapLevels& map) { return filtered_by_mean(map.levels.front(), map.size_m); }}};
    return all;
}

void measure_ink(const InkMeasureArguments& arguments)
{
    require_outputs({arguments.result.output()}, {});
    std::vector<MapLevels> maps;
    for (const std::filesystem::path& folder : arguments.maps) maps.push_back(read_map(folder));
    JsonValue rows = JsonValue::array();
    std::map<std::string, double> largest;
    print_line(fmt::format("{:<20}{:<12}{:>6}{:>8}{:>10}{:>11}{:>9}{:>9}{:>9}{:>9}", "map", "levels", "level", "texels",
                           "stroke", "error", "tone", "of 0", "of last", "contrast"));
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const std::string name = std::filesystem::weakly_canonical(arguments.maps[i]).filename().string();
        for (const auto& [filter, levels_of] : filters()) {
            const double step = add_rows(rows, name, filter, levels_of(maps[i]));
            double& most = largest.try_emplace(filter, step).first->second;
            most = std::fmax(most, step);
        }
    }
    JsonValue summary = JsonValue::array();
    for (const auto& [filter, levels_of] : filters())
        summary.push(JsonValue::object().set("filter", filter).set("largest_tone_step", largest[filter]));
    arguments.result.write(JsonValue::object().set("rows", std::move(rows)).set("summary", std::move(summary)));
}

}  // namespace

void add_measure_ink(CommandLine measure)
{
    auto arguments = std::make_shared<InkMeasureArguments>();
    CommandLine command = measure.add_subcommand(
        "ink", "Stroke width, tone and contrast of ink maps level by level, beside minimum and box filtering");
    command.add_option("maps", arguments->maps, "Folders of maps, each with its map.json")
        .required()
        .option_text("MAP...");
    arguments->result.add_to(command);
    command.callback([arguments] { measure_ink(*arguments); });
}

}  // namespace hw
