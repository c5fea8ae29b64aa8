// What the potentially visible set costs at each effort, how much more it shows than sampled rays see, and what it
// hides that a ray sees: that must be nothing.
#include <fmt/format.h>

#include "hatchway/core/error.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/io/level/file.hpp"
#include "hatchway/stage/level_world.hpp"
#include "measure/measure_result.hpp"
#include "measure/measures.hpp"
#include "measure/no_value.hpp"
#include "measure/random_seed.hpp"
#include "measure/visibility/pvs_measure.hpp"
#include "measure/visibility/slit_scenes.hpp"
#include "program/arguments.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

struct PvsMeasureArguments {
    std::vector<std::filesystem::path> files;
    std::uint64_t rays = 10'000'000;
    std::vector<std::string> efforts{"fast", "full"};
    int threads = 0;
    std::uint32_t seed = 1;
    MeasureResult result;
};

std::uint64_t bytes_of(const Visibility& visibility)
{
    const auto bytes = [](const LeafRows& rows) {
        return rows.leaf_count() == 0 ? 0 : static_cast<std::uint64_t>(rows.leaf_count()) * rows.row(0).size_bytes();
    };
    return bytes(visibility.rows) + bytes(visibility.slot_rows);
}

/// How much more the rows show than rays met. Of few cells that is chance, and rows that hide nothing are no estimate.
double over_estimate(const measure::PvsRayResult& rays)
{
    constexpr int kFewCells = 30;
    if (rays.clusters < kFewCells || rays.row_share >= 1.0) return measure::kNoValue;
    return measure::share_of(rays.row_share, rays.sampled_share);
}

JsonValue row_json(const std::string& file, const std::string& effort, const Visibility& visibility,
                   const measure::PvsRayResult& rays)
{
    const VisibilityStats& stats = visibility.stats;
    JsonValue row = JsonValue::object();
    row.set("file", file).set("effort", effort).set("seconds", stats.seconds);
    row.set("leaves", stats.leaves).set("clusters", stats.clusters).set("portals", stats.portals);
    row.set("coarse_portals", stats.coarse_portals).set("average_visible_share", stats.average_visible_share);
    row.set("rays", rays.rays).set("hits", rays.hits).set("claims", rays.claims);
    row.set("false_invisibles", rays.false_invisibles);
    row.set("sampled_clusters", rays.clusters).set("row_share", rays.row_share);
    row.set("sampled_share", rays.sampled_share).set("over_estimate", over_estimate(rays));
    row.set("bytes", bytes_of(visibility));
    return row;
}

void measure_file(const std::filesystem::path& file, const PvsMeasureArguments& arguments, JsonValue& rows)
{
    const Level level = read_level(file);
    Scene scene = open_scene(level);
    std::vector<MeshChunks> chunks;
    for (MeshData& mesh : scene.meshes) chunks.push_back(split_into_chunks(mesh));
    for (const std::string& effort : arguments.efforts) {
        VisibilityOptions options;
        options.effort = pvs_effort(effort);
        options.threads = arguments.threads;
        const Visibility visibility = build_visibility(scene, level, chunks, options);
        if (visibility.stats.structure_polygons + visibility.stats.detail_polygons == 0)
            throw Error(
                {.what = "has no polygon that hides anything", .file = file.string(), .expected = "opaque faces"});
        const auto rays = measure::measure_pvs(
            scene, chunks, visibility, {.rays = arguments.rays, .seed = arguments.seed, .threads = arguments.threads});
        if (rays.hits == 0)
            throw Error({.what = "no ray met anything", .file = file.string(), .expected = "opaque faces to be seen"});
        rows.push(row_json(file.filename().string(), effort, visibility, rays));
    }
}

/// "seen as known", "hidden as known", "shown, hidden is known" or "LOST, seen is known". Only the last one is an
/// error; rows may show too much. Where the eye counts as inside of a wall, all is shown and nothing is proven.
std::string slit_verdict(bool is_shown, bool is_seen, bool reads_row)
{
    if (!reads_row) return "shown, for no row is read there";
    if (is_shown == is_seen) return is_seen ? "seen as known" : "hidden as known";
    return is_shown ? "shown, hidden is known" : "LOST, seen is known";
}

JsonValue measure_slits(const PvsMeasureArguments& arguments)
{
    JsonValue rows = JsonValue::array();
    for (measure::SlitScene& slit : measure::slit_scenes()) {
        std::vector<MeshChunks> chunks;
        for (MeshData& mesh : slit.scene.meshes) chunks.push_back(split_into_chunks(mesh));
        for (const std::string& effort : arguments.efforts) {
            VisibilityOptions options;
            options.effort = pvs_effort(effort);
            options.threads = arguments.threads;
            const Visibility visibility = build_visibility(slit.scene, {}, chunks, options);
            const bool is_shown = measure::is_target_shown(slit, visibility);
            const bool reads_row = measure::reads_row(slit, visibility);
            log_warning(fmt::format("{}: {} ({})", slit.name, slit_verdict(is_shown, slit.is_seen, reads_row), effort));
            JsonValue row = JsonValue::object();
            row.set("scene", slit.name).set("effort", effort).set("is_seen", slit.is_seen).set("is_shown", is_shown);
            row.set("is_met_by_exact_ray", measure::is_target_met(slit));
            row.set("reads_row", reads_row);
            if (reads_row) row.set("is_lost", slit.is_seen && !is_shown);
            rows.push(std::move(row));
        }
    }
    return rows;
}

void measure_pvs_command(const PvsMeasureArguments& arguments)
{
    require_outputs({arguments.result.output()}, arguments.files);
    JsonValue slits = measure_slits(arguments);
    JsonValue rows = JsonValue::array();
    for (const std::filesystem::path& file : arguments.files) measure_file(file, arguments, rows);
    JsonValue json = JsonValue::object();
    json.set("measure", "pvs").set("rows", std::move(rows)).set("slits", std::move(slits));
    arguments.result.write(json);
    print_lines(json.text());
}

}  // namespace

void add_measure_pvs(CommandLine measure)
{
    auto arguments = std::make_shared<PvsMeasureArguments>();
    CommandLine command =
        measure.add_subcommand("pvs", "Seconds, over-estimate and false invisibles of the potentially visible set");
    command.add_option("files", arguments->files, "Levels or models; none: only the built-in scenes with slits");
    command.add_option("--rays", arguments->rays, "Rays for each effort").check(whole_number_in(1, 1'000'000'000));
    command.add_option("--pvs", arguments->efforts, "Efforts to measure").check(one_of(kPvsEfforts)).delimiter(',');
    command.add_option("-j,--threads", arguments->threads, "Threads; 0 for all").check(whole_number_in(0, 1024));
    add_seed(command, arguments->seed, "rays");
    arguments->result.add_to(command);
    command.callback([arguments] { measure_pvs_command(*arguments); });
}

}  // namespace hw
