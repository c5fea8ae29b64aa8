// Milliseconds per phase of a frame along a path, for every combination of style, samples and effort of the PVS. The
// error beside the time of an effort is the share of pixels that differ from the frame drawn without a PVS, which has
// to be zero.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "hatchway/core/error.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/core/progress.hpp"
#include "hatchway/gl/context.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/world/visibility/visibility.hpp"
#include "measure/frame/frame_series.hpp"
#include "measure/measure_result.hpp"
#include "measure/measures.hpp"
#include "measure/no_value.hpp"
#include "program/arguments.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"
#include "program/pictures/shots.hpp"

namespace hw {
namespace {

struct FrameMeasureArguments {
    LevelArguments level;
    std::string path = kTour;
    int frames = 50;
    std::string size = "1280x720";
    std::vector<std::string> efforts = kPvsEfforts;
    MeasureResult result;
};

constexpr const char* kNoPvs = "none";

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

/// The level as one effort compiles it.
struct EffortStage {
    std::string effort;
    std::unique_ptr<Stage> stage;
    double visible_share = 1.0;  ///< Of the scene's triangles in the row at the eye, mean over the path.
};

/// One combination and what its frames took.
struct Row {
    std::string style;
    int samples = 1;
    std::string pvs;
    double visible_share = 1.0;
    double compile_s = 0.0;
    measure::FrameSeries series;  ///< Pictures are compared with those without the PVS.
};

double quantile(std::vector<double> values, double share)
{
    if (values.empty()) return measure::kNoValue;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

double phase_ms(const Row& row, const Phase& phase, double share)
{
    std::vector<double> values;
    for (const FrameStats& stats : row.series.frames) values.push_back(stats.*phase.ms);
    return quantile(std::move(values), share);
}

/// Of the scene's triangles, those that the rows at the views' eyes show; mean.
double visible_share(const Stage& stage, const std::vector<View>& views)
{
    std::vector<std::uint8_t> is_visible;
    double seen = 0.0, all = 0.0;
    for (const View& view : views) {
        visible_chunks(*stage.visibility(), view.eye_world, 0.0, is_visible);
        for (std::size_t i = 0; i < is_visible.size(); ++i) {
            const ChunkSlot& slot = stage.visibility()->slots[i];
            const int mesh = stage.scene().objects[slot.object].mesh;
            const double triangles = stage.chunks()[mesh][slot.chunk].index_count / 3.0;
            all += triangles;
            if (is_visible[i]) seen += triangles;
        }
    }
    return measure::share_of(seen, all);
}

/// Rows of one style and one number of samples: without the PVS, then at every effort.
std::vector<Row> measure_rows(const std::vector<EffortStage>& stages, const std::vector<View>& views,
                              const std::string& style, int samples, Progress& progress)
{
    std::vector<Row> rows{Row{.style = style, .samples = samples, .pvs = kNoPvs}};
    std::vector<measure::FrameVariant> variants{{&stages.front().stage->renderer(), false}};
    for (const EffortStage& level : stages) {
        const Visibility* visibility = level.stage->visibility();
        if (visibility == nullptr) continue;
        rows.push_back({.style = style,
                        .samples = samples,
                        .pvs = level.effort,
                        .visible_share = level.visible_share,
                        .compile_s = visibility->stats.seconds});
        variants.push_back({&level.stage->renderer(), true});
    }
    std::vector<measure::FrameSeries> series =
        measure::draw_in_turn(variants, views, samples, [&] { progress.advance(); });
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].series = std::move(series[i]);
    return rows;
}

/// Of frames that show nothing there is none.
double unlike_share(const Row& row)
{
    const auto has_drawn = [](const FrameStats& stats) { return stats.triangles > 0; };
    return std::ranges::any_of(row.series.frames, has_drawn) ? row.series.unlike_share : measure::kNoValue;
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
    for (const FrameStats& stats : row.series.frames) triangles.push_back(static_cast<double>(stats.triangles));
    JsonValue json = JsonValue::object();
    json.set("style", row.style).set("samples", row.samples).set("pvs", row.pvs);
    json.set("visible_share", row.visible_share).set("compile_s", row.compile_s);
    json.set("frames", static_cast<std::uint64_t>(row.series.frames.size()));
    json.set("median_ms", std::move(median)).set("p95_ms", std::move(p95));
    json.set("median_triangles", quantile(std::move(triangles), 0.5));
    json.set("pixels_unlike_without_pvs", unlike_share(row));
    return json;
}

std::string row_text(const Row& row)
{
    std::string text =
        fmt::format("{:<16} {} sample{} PVS {:<5}", row.style, row.samples, row.samples == 1 ? " " : "s", row.pvs);
    for (const Phase& phase : kPhases)
        text += fmt::format("  {} {:.2f} ({:.2f})", phase.name, phase_ms(row, phase, 0.5), phase_ms(row, phase, 0.95));
    if (row.pvs != kNoPvs)
        text += fmt::format("  visible {:.1f} %, pixels unlike without PVS {:.4f} %", 100.0 * row.visible_share,
                            100.0 * unlike_share(row));
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

void draw_all_in(const std::vector<EffortStage>& stages, const std::string& plugin)
{
    AssignRule rule;
    rule.style = plugin;
    rule.pointer = "style " + plugin;
    for (const EffortStage& level : stages) level.stage->set_extra_rules({rule});
}

/// The level once for every effort; once without a PVS where there is none.
std::vector<EffortStage> open_stages(Context& context, const FrameMeasureArguments& arguments)
{
    std::vector<EffortStage> stages;
    for (const std::string& effort : arguments.efforts) {
        StageOptions options = stage_options(arguments.level);
        options.visibility.effort = pvs_effort(effort);
        // A cache gives out what was compiled with more effort, too.
        if (options.cache) options.cache->folder /= effort;
        stages.push_back({effort, std::make_unique<Stage>(context, options)});
        if (options.visibility_use == VisibilityUse::none) break;
    }
    return stages;
}

std::vector<View> views_of(const Stage& stage, const ShotArguments& arguments, const glm::ivec2& size)
{
    std::vector<View> views;
    for (const Shot& shot : shots_of(arguments, stage.level(), stage.scene(), static_cast<double>(size.x) / size.y)) {
        views.push_back(camera_view(shot.camera, size, stage.world().places.boxes_world));
        views.back().time_s = shot.time_s;
    }
    return views;
}

void measure_frame(const FrameMeasureArguments& arguments)
{
    const glm::ivec2 size = parse_size(arguments.size);
    const ShotArguments shot_arguments{.path = arguments.path, .frames = arguments.frames};
    check_shot_arguments(shot_arguments);
    require_outputs({arguments.result.output()}, {arguments.level.file});
    const auto context = make_headless_context();
    require_fits(size, context->device());
    std::vector<EffortStage> stages = open_stages(*context, arguments);
    const std::vector<View> views = views_of(*stages.front().stage, shot_arguments, size);
    for (EffortStage& level : stages)
        if (level.stage->visibility() != nullptr) level.visible_share = visible_share(*level.stage, views);
    const std::vector<std::string> styles = styles_to_measure(*stages.front().stage, arguments.level);
    Progress progress("Measuring", styles.size() * 2 * views.size());
    JsonValue rows = JsonValue::array();
    print_line(std::string("median (95th percentile) ms on ") + context->device().renderer);
    for (std::size_t i = 0; i < styles.size(); ++i) {
        if (i > 0) draw_all_in(stages, styles[i]);
        for (const int samples : {1, 4})
            for (const Row& row : measure_rows(stages, views, styles[i], samples, progress)) {
                print_lines(row_text(row));
                rows.push(row_json(row));
            }
    }
    arguments.result.write(JsonValue::object()
                               .set("level", arguments.level.file.string())
                               .set("path", arguments.path)
                               .set("size", arguments.size)
                               .set("device", context->device().renderer)
                               .set("rows", std::move(rows)));
}

}  // namespace

void add_measure_frame(CommandLine measure)
{
    auto arguments = std::make_shared<FrameMeasureArguments>();
    CommandLine command = measure.add_subcommand(
        "frame", "Milliseconds per phase along a path: styles, 1 and 4 samples, without the PVS and at each effort");
    add_level_arguments(command, arguments->level);
    command.add_option("--path", arguments->path, "A camera path of the level, or turntable; tour").option_text("NAME");
    command.add_option("--frames", arguments->frames, "Frames for each row, spread evenly; 50")
        .option_text("N")
        .check(whole_number_in(1, 100'000));
    command.add_option("--size", arguments->size, "Size of the picture, 1280x720").option_text("WxH");
    command.add_option("--pvs", arguments->efforts, "Efforts beside none; fast,full,exact")
        .check(one_of(kPvsEfforts))
        .delimiter(',');
    arguments->result.add_to(command);
    command.callback([arguments] { measure_frame(*arguments); });
}

}  // namespace hw
