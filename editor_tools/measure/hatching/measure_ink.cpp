// Ink maps level by level: width of strokes, tone and contrast, of the map as it was made, of one made anew from the
// pixels of its finest level, and of what minimum and box filtering make of that level.
#include <fmt/format.h>

#include <cmath>

#include "hatchway/core/plain_text.hpp"
#include "hatchway/io/images/map_file.hpp"
#include "hatchway/io/json/out.hpp"
#include "hatchway/maps/bitmap_strokes.hpp"
#include "hatchway/maps/ink_map.hpp"
#include "measure/hatching/ink_level.hpp"
#include "measure/measures.hpp"
#include "program/arguments.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

struct InkMeasureArguments {
    std::vector<std::filesystem::path> maps;
    std::filesystem::path json;
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
    return to > 0.0 ? value / to - 1.0 : 0.0;
}

void add_rows(JsonValue& rows, const std::string& name, const std::string& filter, const MapLevels& map)
{
    const InkLevelFigures finest = ink_level_figures(map.levels.front());
    InkLevelFigures above = finest;
    for (std::size_t i = 0; i < map.levels.size(); ++i) {
        const InkLevelFigures level = ink_level_figures(map.levels[i]);
        const double tone_error = relative(level.tone, finest.tone), tone_step = relative(level.tone, above.tone);
        above = level;
        const bool has_strokes = level.stroke_texels > 0.0 && finest.stroke_texels > 0.0;
        const double width_error = has_strokes ? level.stroke_texels / finest.stroke_texels - 1.0 : 0.0;
        const double kept = finest.contrast > 0.0 ? level.contrast / finest.contrast : 0.0;
        const std::string stroke = has_strokes
                                       ? fmt::format("{:>10.2f}{:>+9.0f} %", level.stroke_texels, 100.0 * width_error)
                                       : fmt::format("{:>21}", "none");
        print_line(fmt::format("{:<20}{:<12}{:>6}{:>8}{}{:>9.3f}{:>+7.0f} %{:>+7.0f} %{:>9.2f}", name, filter, i,
                               map.levels[i].width, stroke, level.tone, 100.0 * tone_error, 100.0 * tone_step, kept));
        rows.push(JsonValue::object()
                      .set("map", name)
                      .set("filter", filter)
                      .set("level", static_cast<std::uint64_t>(i))
                      .set("width_texels", map.levels[i].width)
                      .set("stroke_texels", level.stroke_texels)
                      .set("stroke_error", width_error)
                      .set("tone", level.tone)
                      .set("tone_error", tone_error)
                      .set("tone_step", tone_step)
                      .set("contrast_kept", kept));
    }
}

void measure_ink(const InkMeasureArguments& arguments)
{
    require_outputs({{"--json", arguments.json}}, {});
    std::vector<MapLevels> maps;
    for (const std::filesystem::path& folder : arguments.maps) maps.push_back(read_map(folder));
    JsonValue rows = JsonValue::array();
    print_line(fmt::format("{:<20}{:<12}{:>6}{:>8}{:>10}{:>11}{:>9}{:>9}{:>9}{:>9}", "map", "levels", "level", "texels",
                           "stroke", "error", "tone", "of 0", "of last", "contrast"));
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const MapLevels& map = maps[i];
        const std::string name = std::filesystem::weakly_canonical(arguments.maps[i]).filename().string();
        add_rows(rows, name, "as made", map);
        add_rows(rows, name, "from pixels", from_pixels(map.levels.front(), map));
        add_rows(rows, name, "minimum", filtered_by_minimum(map.levels.front(), map.size_m));
        add_rows(rows, name, "box", filtered_by_mean(map.levels.front(), map.size_m));
    }
    if (!arguments.json.empty()) write_json(arguments.json, JsonValue::object().set("rows", std::move(rows)));
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
    add_json_argument(command, arguments->json);
    command.callback([arguments] { measure_ink(*arguments); });
}

}  // namespace hw
