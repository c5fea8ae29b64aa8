#include <fmt/format.h>

#include <chrono>
#include <numbers>

#include "hatchway/core/error.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/drawing/level_lines.hpp"
#include "hatchway/io/drawings/pdf_drawing.hpp"
#include "hatchway/io/drawings/svg_drawing.hpp"
#include "hatchway/io/json/out.hpp"
#include "hatchway/render/view/line_camera.hpp"
#include "hatchway/stage/level_styles.hpp"
#include "measure/lines/timed_lines.hpp"
#include "program/arguments.hpp"
#include "program/commands.hpp"
#include "program/level/level_doubts.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"
#include "program/pictures/shots.hpp"

namespace hw {
namespace fs = std::filesystem;
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;

struct LinesArguments {
    fs::path file;
    std::vector<std::string> styles;
    PluginArguments plugins;
    ShotArguments shot;
    std::string size = "1280x720";
    fs::path out;
    std::string hidden = "none";
    std::string mode = "all";
    std::optional<double> crease_deg;
    int runs = 1;
    fs::path json;
};

void check_arguments(const LinesArguments& arguments)
{
    parse_size(arguments.size);
    check_shot_arguments(arguments.shot);
    if (arguments.out.extension() != ".svg" && arguments.out.extension() != ".pdf")
        throw Error({.what = "--out " + arguments.out.string(), .expected = "a name that ends in .svg or .pdf"});
    require_outputs({{"--out", arguments.out}, {"--json", arguments.json}}, {arguments.file});
}

VisibleLineOptions line_options(const LinesArguments& arguments)
{
    return {.with_hidden = arguments.hidden == "dashed",
            .with_creases = arguments.mode != "contour",
            .with_artist = arguments.mode == "all"};
}

/// The styles decide, where there are any: a bare model that was given none is drawn with one pen.
LevelLines lines_of(const LinesArguments& arguments, const Level& level, const Scene& scene,
                    const PluginRegistry& registry, const View& view)
{
    std::optional<float> crease_rad;
    if (arguments.crease_deg) crease_rad = static_cast<float>(*arguments.crease_deg * kRadians);
    if (level.file == level.scene_file && arguments.styles.empty()) {
        LevelLines::OnePen pen{.has_intersections = arguments.mode == "all"};
        pen.crease_rad = crease_rad.value_or(pen.crease_rad);
        return LevelLines(scene, pen);
    }
    return LevelLines(scene, level_pens(level, scene, registry, view), crease_rad);
}

/// Where the time goes: what is done once for a scene, and what for each view (the median of the runs).
struct LineTimes {
    double prepare_ms = 0.0;
    double find_ms = 0.0;
};

double ms_since(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

JsonValue point_json(double x, double y)
{
    const auto rounded = [](double value) { return std::round(value * 1e4) / 1e4; };
    return JsonValue::array().push(rounded(x)).push(rounded(y));
}

JsonValue exact_vector(const glm::dvec3& v)
{
    return JsonValue::array().push(JsonValue::exact(v.x)).push(JsonValue::exact(v.y)).push(JsonValue::exact(v.z));
}

JsonValue lines_json(const std::vector<VisibleLine>& found, const LevelLines& level, const LineCamera& camera,
                     const std::string& mode, const LineTimes& times)
{
    JsonValue lines = JsonValue::array();
    for (const VisibleLine& line : found) {
        JsonValue points = JsonValue::array();
        for (const glm::dvec2& point : line.points_px) points.push(point_json(point.x, point.y));
        JsonValue json = JsonValue::object();
        json.set("object", level.name(line.object)).set("class", line_class_name(line.line_class));
        if (line.set > 0) json.set("set", static_cast<int>(line.set));
        json.set("visible", line.is_visible).set("closed", line.is_closed).set("points", std::move(points));
        lines.push(std::move(json));
    }
    JsonValue json = JsonValue::object();
    json.set("width", camera.size_px.x).set("height", camera.size_px.y);
    if (camera.orthographic_height_m)
        json.set("orthographic_height_m", *camera.orthographic_height_m);
    else
        json.set("vfov_deg", camera.fov_rad / kRadians);
    if (camera.roll_rad != 0.0) json.set("roll_deg", camera.roll_rad / kRadians);
    json.set("eye", exact_vector(camera.eye_world)).set("target", exact_vector(camera.target_world));
    json.set("prepare_ms", times.prepare_ms).set("find_ms", times.find_ms);
    return json.set("mode", mode).set("lines", std::move(lines));
}

void write_results(const LinesArguments& arguments, const std::vector<VisibleLine>& found, LevelLines& lines,
                   const LineCamera& camera, const Level& level, const LineTimes& times)
{
    require_unread({{"--out", arguments.out}, {"--json", arguments.json}});
    VectorDrawing drawing = lines.drawing(found, camera);
    drawing.title = arguments.file.stem().stem().string();
    if (level.background) drawing.paper_srgb = *level.background;
    arguments.out.extension() == ".svg" ? write_svg(arguments.out, drawing) : write_pdf(arguments.out, drawing);
    if (!arguments.json.empty()) write_json(arguments.json, lines_json(found, lines, camera, arguments.mode, times));
}

void draw_lines(const LinesArguments& arguments)
{
    check_arguments(arguments);
    const glm::ivec2 size = parse_size(arguments.size);
    const Level level = read_level_with(arguments.file, arguments.styles);
    const PluginRegistry registry({.folders = arguments.plugins.folders, .trial = arguments.plugins.trial()});
    Scene scene = open_scene(level);
    forget_unknown_styles(level, registry, scene);
    for (const std::string& doubt : scene.doubts) log_warning(doubt);
    warn_of_idle_styles(level, scene, arguments.styles.size());
    const Shot shot = shots_of(arguments.shot, level, scene, static_cast<double>(size.x) / size.y).front();
    const std::vector<Box> boxes_world = find_places(scene).boxes_world;
    const View view = camera_view(shot.camera, size, boxes_world);
    warn_of_what_is_beyond(view, boxes_world);
    const LineCamera camera = line_camera(shot.camera, view);
    const auto start = std::chrono::steady_clock::now();
    LevelLines lines = lines_of(arguments, level, scene, registry, view);
    VisibleLineOptions options = line_options(arguments);
    if (arguments.mode == "all") options.intersections = lines.intersections();
    LineTimes times{.prepare_ms = ms_since(start)};
    double find_s = 0.0;
    const std::vector<VisibleLine> found =
        timed_visible_lines(lines.objects(), camera, options, arguments.runs, find_s);
    times.find_ms = 1e3 * find_s;
    write_results(arguments, found, lines, camera, level, times);
    print_line(fmt::format("prepared in {:.1f} ms", times.prepare_ms));
    const auto seen = std::count_if(found.begin(), found.end(), [](const auto& line) { return line.is_visible; });
    print_line(fmt::format("{} triangles, {} objects: {} visible and {} hidden lines in {:.1f} ms",
                           drawn_triangle_count(scene), scene.objects.size(), seen,
                           static_cast<std::ptrdiff_t>(found.size()) - seen, times.find_ms));
}

void add_picture_arguments(CommandLine command, LinesArguments& arguments)
{
    command.add_option("--camera", arguments.shot.camera, "A camera of the level or the model").option_text("NAME");
    command.add_option("--eye", arguments.shot.eye, "Where to look from, metres, y up").option_text("X,Y,Z");
    command.add_option("--target", arguments.shot.target, "What to look at").option_text("X,Y,Z");
    add_projection_arguments(command, arguments.shot);
    command.add_option("--size", arguments.size, "Size of the drawing in pixels, 1280x720").option_text("WxH");
    command.add_option("--out", arguments.out, "The drawing").required().option_text("FILE.svg|FILE.pdf");
}

}  // namespace

void add_lines_command(CommandLine app)
{
    auto arguments = std::make_shared<LinesArguments>();
    CommandLine command = app.add_subcommand("lines", "Draws the visible lines of a level as vectors, SVG or PDF");
    command.add_option("level", arguments->file, "A level, or a bare model").required().option_text("LEVEL|MODEL");
    add_picture_arguments(command, *arguments);
    command.add_option("--hidden", arguments->hidden, "Hidden lines: none, or dashed")
        .option_text("HOW")
        .check(one_of({"dashed", "none"}));
    command
        .add_option("--mode", arguments->mode,
                    "contour: silhouettes and borders; contour+crease; or all, also the "
                    "artist's edges and where objects cut each other")
        .option_text("LINES")
        .check(one_of({"contour", "contour+crease", "all"}));
    command
        .add_option("--crease-deg", arguments->crease_deg,
                    "Edges folded by more are creases; as the styles say, 40 for a bare model")
        .option_text("F")
        .check(number_in(0.1, 180.0));
    command.add_option("--style", arguments->styles, "Style nodes, such as '*=pen_and_ink'; as often as wanted")
        .option_text("GLOB=STYLE");
    command.add_option("--runs", arguments->runs, "Find the lines so many times and tell the median time")
        .option_text("N")
        .check(whole_number_in(1, 1'000));
    add_plugin_arguments(command, arguments->plugins);
    add_json_argument(command, arguments->json);
    command.callback([arguments] { draw_lines(*arguments); });
}

}  // namespace hw
