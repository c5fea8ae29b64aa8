// Random walks through a scene, judged by an oracle that knows nothing of the walker: what must never happen is
// counted, with what it took.
#include <fmt/format.h>

#include <chrono>

#include "hatchway/core/error.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/io/level/file.hpp"
#include "hatchway/stage/level_world.hpp"
#include "hatchway/walk/walk_styles.hpp"
#include "hatchway/world/looks.hpp"
#include "measure/measure_result.hpp"
#include "measure/measures.hpp"
#include "measure/random_seed.hpp"
#include "measure/walk/walk_fuzz.hpp"
#include "measure/walk/walk_places.hpp"
#include "program/arguments.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

using measure::WalkCounts;

struct WalkMeasureArguments {
    std::vector<std::filesystem::path> files;
    std::uint64_t inputs = measure::WalkFuzzOptions{}.inputs;
    std::uint32_t threads = 0;
    std::uint32_t seed = measure::WalkFuzzOptions{}.seed;
    MeasureResult result;
};

JsonValue json_of(const std::string& file, std::size_t starts, double seconds, const WalkCounts& counts)
{
    JsonValue row = JsonValue::object();
    row.set("file", file).set("starts", static_cast<std::uint64_t>(starts)).set("seconds", seconds);
    row.set("inputs", counts.inputs).set("frames", counts.frames).set("walked_s", counts.walked_s);
    row.set("way_m", counts.way_m).set("cells", counts.cells).set("put_back", counts.put_back);
    row.set("lost", counts.lost);
    row.set("penetrations", counts.penetrations).set("worst_depth_m", counts.worst_depth_m);
    row.set("walls_crossed", counts.walls_crossed).set("floors_crossed", counts.floors_crossed);
    row.set("thrown", counts.thrown).set("eyes_parted", counts.eyes_parted).set("stuck", counts.stuck);
    row.set("wrong", counts.wrong());
    return row;
}

void tell_faults(const std::string& file, const WalkCounts& counts)
{
    for (const measure::WalkFault& fault : counts.faults)
        log_warning(fmt::format("{}: {} in walk {}, input {}, foot {:.4f} {:.4f} {:.4f}, {:.6f} m deep", file,
                                fault.what, fault.walk, fault.input, fault.foot_world.x, fault.foot_world.y,
                                fault.foot_world.z, fault.depth_m));
}

JsonValue measure_file(const std::filesystem::path& file, const WalkMeasureArguments& arguments)
{
    const Level level = read_level(file);
    const Scene scene = open_scene(level);
    const std::vector<ObjectLook> looks = resolve_looks(level, scene, kFallbackStyle);
    const CollisionWorld world = build_collision_world(scene, looks);
    const measure::WalkOracle oracle(scene, looks);
    const PlayerBody body = body_for(scene.bounds_world, is_level_file(level.file));
    std::vector<PlayerState> starts = measure::named_places(level, scene, body, world);
    for (const PlayerState& place : measure::scattered_places(oracle, body, world)) starts.push_back(place);
    if (starts.empty()) throw Error({.what = "no place to stand on was found", .file = file.string()});
    const measure::Walker walker = [&](const PlayerState& state, const PlayerInput& input, double seconds) {
        return step(state, input, body, world, seconds);
    };
    const auto begun = std::chrono::steady_clock::now();
    const WalkCounts counts =
        fuzz_walk(oracle, walker, body, starts,
                  {.inputs = arguments.inputs, .threads = arguments.threads, .seed = arguments.seed});
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    const std::string name = file.filename().string();
    tell_faults(name, counts);
    print_line(fmt::format("{:<26}{:>9}{:>9}{:>9.1f}{:>8}{:>7}{:>7}{:>8}{:>10.2g}{:>7}{:>7}{:>7}{:>7}{:>7}", name,
                           counts.inputs, counts.frames, seconds, counts.cells, counts.put_back, counts.lost,
                           counts.penetrations, counts.worst_depth_m, counts.walls_crossed, counts.floors_crossed,
                           counts.thrown, counts.eyes_parted, counts.stuck));
    return json_of(name, starts.size(), seconds, counts);
}

void measure_walk(const WalkMeasureArguments& arguments)
{
    require_outputs({arguments.result.output()}, arguments.files);
    print_lines(
        fmt::format("{:<26}{:>9}{:>9}{:>9}{:>8}{:>7}{:>7}{:>8}{:>10}{:>7}{:>7}{:>7}{:>7}{:>7}\n", "scene", "inputs",
                    "frames", "seconds", "cells", "put", "lost", "pene-", "worst m", "walls", "floors", "thrown",
                    "eyes", "stuck") +
        fmt::format("{:<26}{:>9}{:>9}{:>9}{:>8}{:>7}{:>7}{:>8}\n", "", "", "", "", "0.5 m", "back", "", "trated"));
    JsonValue rows = JsonValue::array();
    for (const std::filesystem::path& file : arguments.files) rows.push(measure_file(file, arguments));
    JsonValue json = JsonValue::object();
    json.set("measure", "walk").set("tolerance_m", measure::WalkFuzzOptions{}.tolerance_m);
    json.set("rows", std::move(rows));
    arguments.result.write(json);
}

}  // namespace

void add_measure_walk(CommandLine measure)
{
    auto arguments = std::make_shared<WalkMeasureArguments>();
    CommandLine command = measure.add_subcommand(
        "walk", "Random walks: bodies in walls, walls and floors passed through, walkers that are stuck");
    command.add_option("files", arguments->files, "Levels or models").required();
    command.add_option("--inputs", arguments->inputs, "Random inputs in each scene, held for 1 to 4 frames")
        .check(whole_number_in(1, 1'000'000'000));
    command.add_option("-j,--threads", arguments->threads, "Threads; 0 for all").check(whole_number_in(0, 1024));
    add_seed(command, arguments->seed, "inputs");
    arguments->result.add_to(command);
    command.callback([arguments] { measure_walk(*arguments); });
}

}  // namespace hw
