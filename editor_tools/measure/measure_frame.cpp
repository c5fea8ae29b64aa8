// Milliseconds per phase of a frame along a path, for every combination of style, samples and PVS. The error beside the
// time of the PVS is the share of pixels that differ from the frame drawn without it, which has to be zero in faces.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <iostream>

#include "core/error.hpp"
#include "core/progress.hpp"
#include "gl/context.hpp"
#include "hatchway/arguments.hpp"
#include "hatchway/option_rules.hpp"
#include "hatchway/output_files.hpp"
#include "hatchway/shots.hpp"
#include "io/json_out.hpp"
#include "measure/measures.hpp"

namespace hw {
namespace {

struct FrameMeasureArguments {
    LevelArguments level;
    std::string path = kTour;
    int frames = 50;
    std::string size = "1280x720";
    std::filesystem::path json;
};

struct Phase {
    const char* name;
    double FrameStats::*ms;
};
constexpr std::array<Phase, 7> kPhases{{{"visibility", &FrameStats::visibility_ms},
                                        {"products", &FrameStats::products_ms},
                                        {"images", &FrameStats::images_ms},
                                        {"surfaces", &FrameStats::surfaces_ms},
                                        {"lines", &FrameStats::lines_ms},
                                        {"resolve", &FrameStats::resolve_ms},
                                        {"total", &FrameStats::total_ms}}};

/// One combination and what its frames took.
struct Row {
    std::string style;
    int samples = 1;
    bool use_pvs = true;
    std::vector<FrameStats> frames;
    double differing_share = 0.0;  ///< Pixels that differ from the frames of the same row without PVS, mean.
};

double quantile(std::vector<double> values, double share)
{
    if (values.empty()) return 0.0;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

double phase_ms(const Row& row, const Phase& phase, double share)
{
    std::vector<double> values;
    for (const FrameStats& stats : row.frames) values.push_back(stats.*phase.ms);
    return quantile(std::move(values), share);
}

double differing_share(const Pixels& a, const Pixels& b)
{
    std::size_t count = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) count += !std::equal(a.at(x, y), a.at(x, y) + a.channels, b.at(x, y));
    return static_cast<double>(count) / (static_cast<double>(a.width) * a.height);
}

/// Draws all shots with the PVS and without, one frame of each after the other, so that a slow moment of the machine
/// meets both.
std::array<Row, 2> measure_rows(Stage& stage, const std::vector<View>& views, const std::string& style, int samples,
                                Progress& progress)
{
    std::array<Row, 2> rows{Row{style, samples, true, {}, 0.0}, Row{style, samples, false, {}, 0.0}};
    FrameOptions options{.samples = samples, .is_timed = true};
    stage.draw(views.front(), options);  // what is made on first use is no part of a frame
    for (const View& view : views) {
        std::array<Pixels, 2> pictures;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            options.use_pvs = rows[i].use_pvs;
            rows[i].frames.push_back(stage.draw(view, options));
            pictures[i] = stage.renderer().read_picture();
        }
        rows[0].differing_share += differing_share(pictures[0], pictures[1]) / static_cast<double>(views.size());
        progress.advance();
    }
    return rows;
}

JsonValue row_json(const Row& row)
{
    JsonValue median = JsonValue::object();
    JsonValue p95 = JsonValue::object();
    for (const Phase& phase : kPhases) {
        median.set(phase.name, phase_ms(row, phase, 0.5));
        p95.set(phase.name, phase_ms(row, phase, 0.95));
    }
    std::vector<double> triangles;
    for (const FrameStats& stats : row.frames) triangles.push_back(static_cast<double>(stats.triangles));
    JsonValue json = JsonValue::object();
    json.set("style", row.style).set("samples", row.samples).set("pvs", row.use_pvs);
    json.set("frames", static_cast<std::uint64_t>(row.frames.size()));
    json.set("median_ms", std::move(median)).set("p95_ms", std::move(p95));
    json.set("median_triangles", quantile(std::move(triangles), 0.5));
    json.set("pixels_unlike_without_pvs", row.differing_share);
    return json;
}

std::string row_text(const Row& row)
{
    std::string text = fmt::format("{:<16} {} sample{} PVS {:<3}", row.style, row.samples, row.samples == 1 ? " " : "s",
                                   row.use_pvs ? "on" : "off");
    for (const Phase& phase : kPhases)
        text += fmt::format("  {} {:.2f} ({:.2f})", phase.name, phase_ms(row, phase, 0.5), phase_ms(row, phase, 0.95));
    if (row.use_pvs) text += fmt::format("  pixels unlike without PVS {:.4f} %", 100.0 * row.differing_share);
    return text + '\n';
}

/// The styles to measure: what the level says, then every style on all objects; only the first when the command line
/// chose styles.
std::vector<std::string> styles_to_measure(const Stage& stage, const LevelArguments& arguments)
{
    std::vector<std::string> styles{"as authored"};
    if (!arguments.styles.empty()) return styles;
    for (const std::string& name : stage.plugins().names(PluginKind::style)) styles.push_back(name);
    return styles;
}

void draw_all_in(Stage& stage, const std::string& plugin)
{
    AssignRule rule;
    rule.style = plugin;
    rule.pointer = "style " + plugin;
    stage.set_extra_rules({rule});
}

void measure_frame(const FrameMeasureArguments& arguments)
{
    const glm::ivec2 size = parse_size(arguments.size);
    const ShotArguments shot_arguments{.path = arguments.path, .frames = arguments.frames};
    check_shot_arguments(shot_arguments);
    require_outputs({{"--json", arguments.json}}, {arguments.level.file});
    const auto context = make_headless_context();
    require_fits(size, context->device());
    Stage stage(*context, stage_options(arguments.level));
    std::vector<View> views;
    for (const Shot& shot :
         shots_of(shot_arguments, stage.level(), stage.scene(), static_cast<double>(size.x) / size.y)) {
        views.push_back(camera_view(shot.camera, size, stage.scene().bounds_world));
        views.back().time_s = shot.time_s;
    }
    const std::vector<std::string> styles = styles_to_measure(stage, arguments.level);
    Progress progress("Measuring", styles.size() * 2 * views.size());
    JsonValue rows = JsonValue::array();
    std::cout << "median (95th percentile) ms on " << context->device().renderer << '\n';
    for (std::size_t i = 0; i < styles.size(); ++i) {
        if (i > 0) draw_all_in(stage, styles[i]);
        for (const int samples : {1, 4})
            for (const Row& row : measure_rows(stage, views, styles[i], samples, progress)) {
                std::cout << row_text(row) << std::flush;
                rows.push(row_json(row));
            }
    }
    if (arguments.json.empty()) return;
    write_json(arguments.json, JsonValue::object()
                                   .set("level", arguments.level.file.string())
                                   .set("path", arguments.path)
                                   .set("size", arguments.size)
                                   .set("device", context->device().renderer)
                                   .set("rows", std::move(rows)));
}

}  // namespace

void add_measure_frame(CLI::App& measure)
{
    auto arguments = std::make_shared<FrameMeasureArguments>();
    CLI::App* command =
        measure.add_subcommand("frame", "Milliseconds per phase along a path: styles, 1 and 4 samples, PVS on and off");
    add_level_arguments(*command, arguments->level);
    command->add_option("--path", arguments->path, "A camera path of the level, or turntable; tour")
        ->option_text("NAME");
    command->add_option("--frames", arguments->frames, "Frames for each row, spread evenly; 50")
        ->option_text("N")
        ->check(whole_number_in(1, 100'000));
    command->add_option("--size", arguments->size, "Size of the picture, 1280x720")->option_text("WxH");
    add_json_argument(*command, arguments->json);
    command->callback([arguments] { measure_frame(*arguments); });
}

}  // namespace hw
