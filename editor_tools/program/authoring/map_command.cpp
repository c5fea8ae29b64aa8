#include <fmt/format.h>

#include <functional>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/files/folder_draft.hpp"
#include "hatchway/core/limits.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/io/drawings/svg_strokes.hpp"
#include "hatchway/io/images/images.hpp"
#include "hatchway/io/json/out.hpp"
#include "hatchway/maps/bitmap_strokes.hpp"
#include "hatchway/maps/hatch_map.hpp"
#include "hatchway/maps/ink_map.hpp"
#include "hatchway/maps/tonal_map.hpp"
#include "program/authoring/map_preview.hpp"
#include "program/commands.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMapFile = "map.json";
constexpr const char* kMapFormat = "hatchway-map/1";
constexpr std::size_t kMostLevels = 13;                   // of 4096 texels
constexpr std::uint64_t kMostDrawingPixels = 36'000'000;  // a sheet of A4 at 600 dots an inch

struct MapArguments {
    fs::path folder;
    fs::path preview;
    fs::path drawing;
    std::string filter = "none";
    InkMapDesc ink;
    HatchMapDesc hatch;
    TonalMapDesc tonal;
    bool has_priorities = false;
};

fs::path level_file(const fs::path& folder, std::size_t level)
{
    return folder / fmt::format("level_{}.png", level);
}

bool is_map_file(const fs::path& name)
{
    const std::string text = name.string();
    return text == kMapFile || (text.starts_with("level_") && text.ends_with(".png"));
}

/// Whether it is a map's description: a picture beside another map.json is somebody's own.
bool is_description(const fs::path& file)
{
    constexpr std::uint64_t kMostBytes = 1 << 20;
    std::error_code failed;
    if (!fs::is_regular_file(fs::symlink_status(file, failed)) || fs::file_size(file, failed) > kMostBytes)
        return false;
    return read_text_file(file, kMostBytes).find(kMapFormat) != std::string::npos;
}

/// The folder is replaced whole, so it may hold nothing but a map and its preview.
void require_replaceable(const MapArguments& arguments)
{
    const auto refuse = [&](const std::string& what) {
        return Error({.what = "--out: " + what,
                      .file = arguments.folder.string(),
                      .expected = "a new name, an empty folder, or one that holds a map alone: it is replaced"});
    };
    const fs::path name = arguments.folder.filename();
    if (name == "." || name == "..") throw refuse("is no name");
    std::error_code missing;
    if (fs::is_symlink(fs::symlink_status(arguments.folder, missing))) return;
    const bool is_map = is_description(arguments.folder / kMapFile);
    for (const fs::directory_entry& entry : fs::directory_iterator(arguments.folder, missing)) {
        const bool is_preview = is_in_folder(arguments.preview, arguments.folder) &&
                                entry.path().filename() == arguments.preview.filename();
        const bool is_file = !fs::is_directory(entry.symlink_status(missing));
        if (!is_file || !(is_preview || (is_map && is_map_file(entry.path().filename()))))
            throw refuse("holds " + entry.path().filename().string());
    }
}

void check_outputs(const MapArguments& arguments)
{
    std::error_code missing;
    if (fs::is_symlink(fs::symlink_status(arguments.folder, missing)))
        require_folder(arguments.folder.parent_path(), "--out");
    else
        require_writable_folder(arguments.folder, "--out");
    require_replaceable(arguments);
    // The preview may lie in the map's own folder, which need not be there yet.
    if (!is_in_folder(arguments.preview, arguments.folder)) require_writable(arguments.preview, "--preview");
    std::vector<OutputFile> outputs{{"--out", arguments.folder}, {"--out", arguments.folder / kMapFile}};
    for (std::size_t i = 0; i < kMostLevels; ++i) outputs.push_back({"--out", level_file(arguments.folder, i)});
    outputs.push_back({"--preview", arguments.preview});
    require_distinct(outputs, {arguments.drawing});
}

void write_map(const MapLevels& map, const MapArguments& arguments)
{
    const Pixels preview = arguments.preview.empty() ? Pixels() : map_preview(map);
    JsonValue json = JsonValue::object();
    json.set("format", kMapFormat).set("kind", std::string(facts_of(map.kind).name));
    json.set("levels", static_cast<int>(map.levels.size())).set("size_m", map.size_m);
    if (map.kind == MapKind::hatch) json.set("spacing_texels", map.spacing_texels);
    const bool is_preview_inside = is_in_folder(arguments.preview, arguments.folder);
    FolderDraft draft(arguments.folder);
    draft.fill([&](const std::filesystem::path& folder) {
        for (std::size_t i = 0; i < map.levels.size(); ++i) write_png(level_file(folder, i), map.levels[i]);
        write_json(folder / kMapFile, json);
        if (is_preview_inside) write_png(folder / arguments.preview.filename(), preview);
    });
    draft.put();
    if (!is_preview_inside && !arguments.preview.empty()) write_png(arguments.preview, preview);
}

int power_of_two(int texels)
{
    int result = 1;
    while (2 * result <= texels) result *= 2;
    return result;
}

/// A drawing's strokes and its height, widths of the drawing.
struct Drawing {
    std::vector<MapStroke> strokes;
    double height_share = 1.0;
    bool has_priorities = false;
};

Drawing read_vector_drawing(const fs::path& file)
{
    const SvgDrawing svg = read_svg_strokes(file);
    Drawing drawing{.strokes = {}, .height_share = svg.height_share};
    for (const SvgStroke& stroke : svg.strokes) {
        drawing.strokes.push_back({.points = stroke.points, .width = stroke.width, .priority = stroke.priority});
        for (glm::dvec2& point : drawing.strokes.back().points) point.y /= svg.height_share;
        drawing.has_priorities = drawing.has_priorities || stroke.has_priority;
    }
    return drawing;
}

Drawing read_bitmap_drawing(const fs::path& file)
{
    const Pixels pixels = read_image(file);
    if (static_cast<std::uint64_t>(pixels.width) * static_cast<std::uint64_t>(pixels.height) > kMostDrawingPixels)
        throw Error({.what = fmt::format("the drawing has {} x {} pixels", pixels.width, pixels.height),
                     .file = file.string(),
                     .expected = fmt::format("at most {} in all", kMostDrawingPixels)});
    Drawing drawing{.strokes = strokes_of_bitmap(pixels), .height_share = double(pixels.height) / pixels.width};
    if (drawing.strokes.empty())
        throw Error({.what = "no ink", .file = file.string(), .expected = "dark lines on light paper"});
    return drawing;
}

Drawing read_drawing(const fs::path& file)
{
    std::string extension = file.extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const bool is_bitmap = extension == ".png" || extension == ".jpg" || extension == ".jpeg";
    return is_bitmap ? read_bitmap_drawing(file) : read_vector_drawing(file);
}

MapLevels ink_map_of(MapArguments& arguments)
{
    Drawing drawing = read_drawing(arguments.drawing);
    if (!drawing.has_priorities) rank_evenly(drawing.strokes);
    arguments.ink.height_texels =
        power_of_two(static_cast<int>(arguments.ink.width_texels * drawing.height_share * 1.4));
    if (arguments.ink.height_texels > limits::kMaxImageSide)
        throw Error({.what = fmt::format("the map would be {} texels high", arguments.ink.height_texels),
                     .file = arguments.drawing.string(),
                     .expected = fmt::format("at most {}: a smaller --width", limits::kMaxImageSide)});
    const InkMap ink = make_ink_map(drawing.strokes, arguments.ink);
    const MapLevels map = arguments.filter == "minimum"
                              ? filtered_by_minimum(ink.map.levels.front(), arguments.ink.size_m)
                          : arguments.filter == "box" ? filtered_by_mean(ink.map.levels.front(), arguments.ink.size_m)
                                                      : ink.map;
    if (arguments.filter != "none") return map;
    for (std::size_t i = 0; i < ink.stroke_counts.size(); ++i)
        print_line(fmt::format("level {}: {} of {} strokes", i, ink.stroke_counts[i], drawing.strokes.size()));
    return map;
}

void make_map(const MapArguments& arguments, const std::function<MapLevels()>& draw)
{
    check_outputs(arguments);
    write_map(draw(), arguments);
}

CommandLine add_kind(CommandLine map, const std::string& name, const std::string& help, MapArguments& arguments)
{
    CommandLine kind = map.add_subcommand(name, help);
    kind.add_option("--out", arguments.folder, "Folder of the map: level_0.png, level_1.png, ... and map.json")
        .required();
    kind.add_option("--preview", arguments.preview,
                    "PNG that shows all levels, and a plane in perspective that the map covers");
    return kind;
}

}  // namespace

void add_map_command(CommandLine app)
{
    auto arguments = std::make_shared<MapArguments>();
    CommandLine map = app.add_subcommand("map", "Draws hatch, ink and tonal maps with their levels");
    map.require_subcommand();

    CommandLine hatch = add_kind(map, "hatch", "Parallel lines, equally far apart at every level", *arguments);
    hatch.add_option("--width", arguments->hatch.width_texels, "Texels of the finest level, a power of two")
        .check(one_of({"64", "128", "256", "512", "1024", "2048", "4096"}));
    hatch.add_option("--spacing", arguments->hatch.spacing_texels, "Texels between lines")
        .check(one_of({"4", "8", "16", "32"}));
    hatch.add_option("--line", arguments->hatch.line_texels, "Width of a line, texels").check(number_in(0.2, 4.0));
    hatch.callback([arguments] { make_map(*arguments, [&] { return make_hatch_map(arguments->hatch); }); });

    CommandLine ink = add_kind(map, "ink", "A drawing, inked anew at every level with the same pen", *arguments);
    ink.add_option("drawing", arguments->drawing, "Strokes in an SVG file, or dark lines in a PNG or JPEG")
        .required()
        .option_text("SVG|PNG|JPEG");
    ink.add_option("--width", arguments->ink.width_texels, "Texels of the finest level")
        .check(one_of({"8", "16", "32", "64", "128", "256", "512", "1024", "2048"}));
    ink.add_option("--pen", arguments->ink.pen_texels, "Width of a stroke, texels").check(number_in(0.5, 8.0));
    ink.add_option("--size-m", arguments->ink.size_m, "Width of the map on a surface").check(number_in(0.001, 1000.0));
    ink.add_option("--filter", arguments->filter,
                   "none: strokes are inked anew at every level; for comparison: minimum, box")
        .check(one_of({"none", "minimum", "box"}));
    ink.callback([arguments] { make_map(*arguments, [&] { return ink_map_of(*arguments); }); });

    CommandLine tonal = add_kind(map, "tonal", "Tones of nested strokes", *arguments);
    TonalMapDesc& desc = arguments->tonal;
    tonal.add_option("--width", desc.size_texels, "Texels of one tone").check(one_of({"64", "128", "256", "512"}));
    tonal.add_option("--tones", desc.tones, "How many tones").check(whole_number_in(2, 32));
    tonal.add_flag("--priority", arguments->has_priorities,
                   "One map of the tone at which each texel turns to ink: for halftone");
    tonal.add_option("--pen", desc.pen_texels, "Width of a stroke, texels").check(number_in(0.5, 8.0));
    tonal.add_option("--length", desc.length_share, "Length of strokes, of the map's width")
        .check(number_in(0.05, 1.0));
    tonal.add_option("--angle-spread-deg", desc.angle_spread_deg, "How far strokes stray").check(number_in(0.0, 45.0));
    tonal.add_option("--cross-deg", desc.cross_angle_deg, "Direction of crossing strokes").check(number_in(0.0, 90.0));
    tonal.add_option("--size-m", desc.size_m, "Width of one tone on a surface").check(number_in(0.001, 1000.0));
    tonal.add_option("--seed", desc.seed, "Of all that is random").check(whole_number_in(0, UINT32_MAX));
    tonal.callback([arguments] {
        make_map(*arguments, [&] {
            return arguments->has_priorities ? make_priority_map(arguments->tonal) : make_tonal_map(arguments->tonal);
        });
    });
}

}  // namespace hw
