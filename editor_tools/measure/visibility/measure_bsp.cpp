// What the tree of a level costs, and whether it tells the truth: every point must be where exact arithmetic on the
// stored planes puts it, and the pieces must cover what the snapped polygons covered.
#include <fmt/format.h>

#include <chrono>

#include "hatchway/core/error.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/geometry/mesh_chunks.hpp"
#include "hatchway/io/level/file.hpp"
#include "hatchway/stage/level_world.hpp"
#include "hatchway/world/visibility/visibility.hpp"
#include "measure/measure_result.hpp"
#include "measure/measures.hpp"
#include "measure/random_seed.hpp"
#include "measure/visibility/bsp_measure.hpp"
#include "program/arguments.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

struct BspMeasureArguments {
    std::vector<std::filesystem::path> files;
    std::uint64_t points = 1'000'000;
    std::uint32_t seed = 1;
    MeasureResult result;
};

JsonValue measure_file(const std::filesystem::path& file, const BspMeasureArguments& arguments)
{
    const Level level = read_level(file);
    Scene scene = open_scene(level);
    // A level's triangles are put in the order of chunks before anything is built of them, and the order decides ties.
    for (MeshData& mesh : scene.meshes) split_into_chunks(mesh);
    const auto start = std::chrono::steady_clock::now();
    VisibilityStats stats;
    double area_m2 = 0.0;
    const BspBuild build = build_sight_tree(scene, level, {}, stats, area_m2);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (stats.structure_polygons + stats.detail_polygons == 0)
        throw Error({.what = "has no polygon that hides anything", .file = file.string(), .expected = "opaque faces"});
    JsonValue row = JsonValue::object();
    row.set("file", file.filename().string()).set("seconds", seconds);
    row.set("polygons", stats.structure_polygons + stats.detail_polygons).set("pieces", build.piece_count);
    row.set("leaves", build.tree.leaf_count).set("depth", build.depth);
    row.set("points", arguments.points);
    row.set("misclassified", measure::misclassified(build.tree, arguments.points, arguments.seed));
    row.set("relative_area_error", measure::relative_area_error(area_m2, build));
    return row;
}

void measure_bsp(const BspMeasureArguments& arguments)
{
    require_outputs({arguments.result.output()}, arguments.files);
    JsonValue rows = JsonValue::array();
    for (const std::filesystem::path& file : arguments.files) rows.push(measure_file(file, arguments));
    JsonValue json = JsonValue::object();
    json.set("measure", "bsp").set("rows", std::move(rows));
    arguments.result.write(json);
    print_lines(json.text());
}

}  // namespace

void add_measure_bsp(CommandLine measure)
{
    auto arguments = std::make_shared<BspMeasureArguments>();
    CommandLine command =
        measure.add_subcommand("bsp", "Seconds, pieces, misclassified points and area error of the BSP");
    command.add_option("files", arguments->files, "Levels or models").required();
    command.add_option("--points", arguments->points, "Points to classify").check(whole_number_in(1, 1'000'000'000));
    add_seed(command, arguments->seed, "points");
    arguments->result.add_to(command);
    command.callback([arguments] { measure_bsp(*arguments); });
}

}  // namespace hw
