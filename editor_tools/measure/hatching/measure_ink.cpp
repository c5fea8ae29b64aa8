// Ink maps level by level: width of strokes, tone and contrast, of the map as it was made or drawn by hand, of one made
// anew from the pixels of its finest level, and of what minimum and box filtering make of that level. All are compared
// with that finest level.
#include <fmt/format.h>

#include <cmath>
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
#include "program/option_rules.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

struct InkMeasureArguments {
    std::vector<std::filesystem::path> maps;
    std::vector<std::filesystem::path> maps_by_hand;
    double pen_texels = InkMapDesc{}.pen_texels;
    MeasureResult result;
};

/// A map as `hatchway map ink --pen` makes it of a drawing in pixels. The pen is given: no judge measures it.
MapLevels from_pixels(const MapLevels& drawing, double pen_texels)
{
    const Pixels& pixels = drawing.levels.front();
    std::vector<MapStroke> strokes = strokes_of_bitmap(pixels);
    rank_evenly(strokes);
    return make_ink_map(strokes, {.width_texels = pixels.width,
                                  .height_texels = pixels.height,
                                  .pen_texels = pen_texels,
                                  .size_m = drawing.size_m})
        .map;
}

double relative(double value, double to)
{
    return measure::share_of(value, to) - 1.0;
}

/// The largest jumps of tone from one level to the next, relative, over all maps.
struct ToneSteps {
    double largest = measure::kNoValue;
    std::string map;  ///< Where that is.
    std::size_t level = 0;
    double largest_after_1 = measure::kNoValue;  ///< From level 1 on: some maps draw level 0 with half the tone.

    void add(const std::string& name, std::size_t at, double step)
    {
        if (at >= 2) largest_after_1 = std::fmax(largest_after_1, std::abs(step));
        if (std::isnan(step) || std::abs(step) <= largest) return;
        largest = std::abs(step);
        map = name;
        level = at;
    }
};

/// Adds the rows of a map, compared with the drawing that its finest level shows.
void add_rows(JsonValue& rows, ToneSteps& steps, const std::string& name, const std::string& filter,
              const MapLevels& map, const InkLevelFigures& drawing)
{
    InkLevelFigures above = drawing;
    for (std::size_t i = 0; i < map.levels.size(); ++i) {
        const InkLevelFigures level = ink_level_figures(map.levels[i]);
        const double tone_error = relative(level.tone, drawing.tone), tone_step = relative(level.tone, above.tone);
        above = level;
        steps.add(name, i, tone_step);
        const bool has_strokes = level.stroke_texels > 0.0 && drawing.stroke_texels > 0.0;
        const double stroke_texels = has_strokes ? level.stroke_texels : measure::kNoValue;
        const double width_error = relative(stroke_texels, drawing.stroke_texels);
        const double kept = measure::share_of(level.contrast, drawing.contrast);
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
}

constexpr const char* kAsMade = "as made";
constexpr const char* kByHand = "by hand";

/// The ways in which a map's levels are made, each with its name; the first is the map as it is.
std::vector<std::pair<const char*, MapLevels>> made_each_way(const MapLevels& map, bool is_by_hand, double pen_texels)
{
    const Pixels& finest = map.levels.front();
    return {{is_by_hand ? kByHand : kAsMade, map},
            {"from pixels", from_pixels(map, pen_texels)},
            {"minimum", filtered_by_minimum(finest, map.size_m)},
            {"box", filtered_by_mean(finest, map.size_m)}};
}

void measure_ink(const InkMeasureArguments& arguments)
{
    require_outputs({arguments.result.output()}, {});
    std::vector<std::filesystem::path> folders = arguments.maps;
    folders.insert(folders.end(), arguments.maps_by_hand.begin(), arguments.maps_by_hand.end());
    std::vector<MapLevels> maps;
    for (const std::filesystem::path& folder : folders) maps.push_back(read_map(folder));
    JsonValue rows = JsonValue::array();
    std::map<std::string, ToneSteps> steps;
    print_line(fmt::format("{:<20}{:<12}{:>6}{:>8}{:>10}{:>11}{:>9}{:>9}{:>9}{:>9}", "map", "levels", "level", "texels",
                           "stroke", "error", "tone", "of drawn", "of last", "contrast"));
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const std::string name = std::filesystem::weakly_canonical(folders[i]).filename().string();
        const InkLevelFigures drawing = ink_level_figures(maps[i].levels.front());
        if (drawing.tone <= 0.0) throw Error({.what = name + ": no ink in its finest level", .expected = "a drawing"});
        const bool is_by_hand = i >= arguments.maps.size();
        for (const auto& [filter, map] : made_each_way(maps[i], is_by_hand, arguments.pen_texels))
            add_rows(rows, steps[filter], name, filter, map, drawing);
    }
    JsonValue summary = JsonValue::array();
    for (const auto& [filter, step] : steps)
        summary.push(JsonValue::object()
                         .set("filter", filter)
                         .set("largest_tone_step", step.largest)
                         .set("of_map", step.map)
                         .set("at_level", static_cast<std::uint64_t>(step.level))
                         .set("largest_tone_step_after_level_1", step.largest_after_1));
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
    command.add_option("--by-hand", arguments->maps_by_hand, "Folders of maps whose levels were drawn one by one")
        .option_text("MAP...");
    command.add_option("--pen", arguments->pen_texels, "Width of a stroke in maps made of a drawing's pixels, texels")
        .check(number_in(0.5, 8.0));
    arguments->result.add_to(command);
    command.callback([arguments] { measure_ink(*arguments); });
}

}  // namespace hw
