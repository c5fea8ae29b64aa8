// What the PVS lets through where people stand: eyes at places that a walker reaches on foot from the level's start and
// cameras. The judge is a ray through every pixel. Beside it what a frame costs with the PVS and without.
#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "hatchway/core/error.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/core/progress.hpp"
#include "hatchway/gl/context.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/render/view/camera_view.hpp"
#include "hatchway/stage/stage.hpp"
#include "hatchway/walk/walk_styles.hpp"
#include "hatchway/world/looks.hpp"
#include "measure/frame/frame_series.hpp"
#include "measure/measure_result.hpp"
#include "measure/measures.hpp"
#include "measure/no_value.hpp"
#include "measure/random_seed.hpp"
#include "measure/visibility/sight_measure.hpp"
#include "measure/walk/walk_places.hpp"
#include "program/arguments.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

constexpr double kCell_m = 0.5;              // of the places that are told apart
constexpr std::size_t kMostPlaces = 20'000;  // that a search for them looks at
constexpr double kFovDeg = 60.0;
constexpr int kRaysAcross = 2;  // of a pixel of the frames

struct VisibilityMeasureArguments {
    std::vector<std::filesystem::path> files;
    int eyes = 50;
    std::string size = "640x400";
    std::string effort = "full";
    std::uint32_t seed = 1;
    MeasureResult result;
};

struct Row {
    std::string file;
    std::string effort;
    std::size_t places = 0;  ///< Cells that were reached on foot.
    std::size_t eyes = 0;
    double compile_s = 0.0;
    measure::SightCounts counts;  ///< Of all eyes.
    double with_ms = 0.0, without_ms = 0.0, visibility_ms = 0.0;
    double unlike_share = 0.0;
};

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double median_ms(const measure::FrameSeries& series, double FrameStats::*phase)
{
    std::vector<double> values;
    for (const FrameStats& stats : series.frames) values.push_back(stats.*phase);
    return median(std::move(values));
}

/// Places that a walker reaches on foot. From the level's own, or where there are none from those of the oracle.
std::vector<PlayerState> places_in(const Stage& stage, const PlayerBody& body)
{
    const CollisionWorld world = build_collision_world(stage.scene(), stage.looks());
    std::vector<PlayerState> starts = measure::named_places(stage.level(), stage.scene(), body, world);
    if (starts.empty())
        starts = measure::scattered_places(measure::WalkOracle(stage.scene(), stage.looks()), body, world);
    const measure::Walker walker = [&](const PlayerState& state, const PlayerInput& input, double seconds) {
        return step(state, input, body, world, seconds);
    };
    return measure::places_on_foot(walker, starts, kCell_m, kMostPlaces);
}

/// Looks level in a random direction from places drawn at random, the same ones for the same seed.
std::vector<View> views_from(std::vector<PlayerState> places, const PlayerBody& body, const glm::ivec2& size,
                             const VisibilityMeasureArguments& arguments, const Box& bounds)
{
    std::mt19937 random(arguments.seed);
    for (std::size_t i = places.size(); i > 1; --i) std::swap(places[i - 1], places[random() % i]);
    std::vector<View> views;
    for (std::size_t i = 0; i < std::min(static_cast<std::size_t>(arguments.eyes), places.size()); ++i) {
        const double yaw = 2.0 * std::numbers::pi * static_cast<double>(random()) / 4294967296.0;
        const glm::dvec3 eye = places[i].foot_world + glm::dvec3(0.0, body.eye_m, 0.0);
        const glm::dvec3 ahead(-std::sin(yaw), 0.0, -std::cos(yaw));
        views.push_back(camera_view({eye, eye + ahead, kFovDeg}, size, bounds));
    }
    return views;
}

Row measure_file(Context& context, const std::filesystem::path& file, const VisibilityMeasureArguments& arguments)
{
    StageOptions options{.file = file, .style_overrides = {"*=photoreal"}};
    options.visibility.effort = pvs_effort(arguments.effort);
    Stage stage(context, options);
    const PlayerBody body = body_for(stage.scene().bounds_world, is_level_file(stage.level().file));
    const glm::ivec2 size = parse_size(arguments.size);
    std::vector<PlayerState> places = places_in(stage, body);
    if (places.empty()) throw Error({.what = "no place to stand on was found", .file = file.string()});
    Row row{.file = file.filename().string(), .effort = arguments.effort, .places = places.size()};
    const std::vector<View> views = views_from(std::move(places), body, size, arguments, stage.scene().bounds_world);
    row.eyes = views.size();
    row.compile_s = stage.visibility()->stats.seconds;
    const measure::SightJudge judge(stage.scene(), stage.chunks(), *stage.visibility());
    Progress progress("Measuring visibility of " + row.file, views.size());
    for (const View& view : views) {
        row.counts.add(judge.judge(view, kRaysAcross * size));
        progress.advance();
    }
    const std::array<measure::FrameVariant, 2> variants{{{&stage.renderer(), false}, {&stage.renderer(), true}}};
    const auto series = measure::draw_in_turn(variants, views, 1);
    row.without_ms = median_ms(series[0], &FrameStats::total_ms);
    row.with_ms = median_ms(series[1], &FrameStats::total_ms);
    row.visibility_ms = median_ms(series[1], &FrameStats::visibility_ms);
    row.unlike_share = series[1].unlike_share;
    return row;
}

double share(std::uint64_t part, std::uint64_t whole)
{
    return measure::share_of(static_cast<double>(part), static_cast<double>(whole));
}

JsonValue row_json(const Row& row)
{
    const measure::SightCounts& c = row.counts;
    JsonValue json = JsonValue::object();
    json.set("file", row.file).set("effort", row.effort).set("compile_s", row.compile_s);
    json.set("places", static_cast<std::uint64_t>(row.places)).set("eyes", static_cast<std::uint64_t>(row.eyes));
    json.set("in_view", c.in_view).set("drawn", c.drawn).set("needed", c.needed).set("met", c.met);
    json.set("drawn_share", share(c.drawn, c.in_view)).set("needed_share", share(c.needed, c.in_view));
    json.set("drawn_over_needed", share(c.drawn, c.needed));
    json.set("rays", c.rays).set("lost", c.lost);
    json.set("frame_ms", row.with_ms).set("frame_ms_without", row.without_ms).set("visibility_ms", row.visibility_ms);
    json.set("pixels_unlike_without_pvs", row.unlike_share);
    return json;
}

std::string row_text(const Row& row)
{
    const measure::SightCounts& c = row.counts;
    return fmt::format(
        "{}: {} eyes of {} places; drawn {:.1f} % of the triangles in view, needed {:.1f} %; lost {} chunks by {} "
        "rays; "
        "compile {:.2f} s; frame {:.2f} ms, {:.2f} without; {:.4f} % of pixels unlike\n",
        row.file, row.eyes, row.places, 100.0 * share(c.drawn, c.in_view), 100.0 * share(c.needed, c.in_view), c.lost,
        c.rays, row.compile_s, row.with_ms, row.without_ms, 100.0 * row.unlike_share);
}

void measure_visibility(const VisibilityMeasureArguments& arguments)
{
    require_outputs({arguments.result.output()}, arguments.files);
    const auto context = make_headless_context();
    require_fits(parse_size(arguments.size), context->device());
    JsonValue rows = JsonValue::array();
    for (const std::filesystem::path& file : arguments.files) {
        const Row row = measure_file(*context, file, arguments);
        print_lines(row_text(row));
        rows.push(row_json(row));
    }
    JsonValue json = JsonValue::object();
    json.set("measure", "visibility").set("device", context->device().renderer).set("size", arguments.size);
    json.set("rows", std::move(rows));
    arguments.result.write(json);
}

}  // namespace

void add_measure_visibility(CommandLine measure)
{
    auto arguments = std::make_shared<VisibilityMeasureArguments>();
    CommandLine command = measure.add_subcommand(
        "visibility", "Where a walker can stand: triangles in view, drawn with the PVS, and truly seen; frames");
    command.add_option("FILES", arguments->files, "Levels or models").required().option_text("MODEL|LEVEL...");
    command.add_option("--eyes", arguments->eyes, "Eyes in each; 50")
        .option_text("N")
        .check(whole_number_in(1, 10'000));
    add_seed(command, arguments->seed, "eyes");
    command.add_option("--size", arguments->size, "Size of the frames, 640x400; four rays judge each pixel")
        .option_text("WxH");
    command.add_option("--pvs", arguments->effort, "Effort, full").check(one_of(kPvsEfforts));
    arguments->result.add_to(command);
    command.callback([arguments] { measure_visibility(*arguments); });
}

}  // namespace hw
