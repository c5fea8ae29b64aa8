// What the tree costs, and whether it tells the truth: every point must be where exact arithmetic on the stored planes
// puts it, and the pieces must cover what the snapped polygons covered.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <iostream>
#include <random>

#include "hatchway/arguments.hpp"
#include "hatchway/option_rules.hpp"
#include "hatchway/output_files.hpp"
#include "io/gltf_import.hpp"
#include "io/json_out.hpp"
#include "io/level_file.hpp"
#include "measure/bsp_oracle.hpp"
#include "measure/measures.hpp"
#include "world/structure.hpp"

namespace hw {
namespace {

struct BspMeasureArguments {
    std::vector<std::filesystem::path> files;
    std::uint64_t points = 1'000'000;
    std::filesystem::path json;
};

/// Every other point lies within a few grid steps of a plane of the tree: the ones that a careless test gets wrong.
std::uint64_t misclassified(const BspTree& tree, std::uint64_t points)
{
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::uint64_t wrong = 0;
    for (std::uint64_t i = 0; i < points; ++i) {
        glm::dvec3 point =
            tree.bounds_world.min + tree.bounds_world.size() * glm::dvec3(share(engine), share(engine), share(engine));
        if (i % 2 == 1 && !tree.nodes.empty()) {
            const ExactPlane& plane = tree.nodes[engine() % tree.nodes.size()].plane;
            const double distance = plane.distance((point - tree.grid.origin_world) / tree.grid.step_m);
            const double aside = std::pow(10.0, -12.0 * share(engine)) * (share(engine) - 0.5);
            point -= plane.unit_normal * ((distance + aside) * tree.grid.step_m);
        }
        wrong += leaf_at(tree, point) != measure::leaf_by_rationals(tree, point);
    }
    return wrong;
}

double area_m2(const BspBuild& build)
{
    double sum = 0.0;
    for (const auto& pieces : build.polygons_of_node) {
        for (const BlockingPolygon& piece : pieces) sum += area(piece.polygon);
    }
    return sum * build.tree.grid.step_m * build.tree.grid.step_m;
}

JsonValue measure_file(const std::filesystem::path& file, std::uint64_t points)
{
    const Level level = read_level(file);
    const Scene scene = import_gltf(level.scene_file, level.project_root);
    const auto start = std::chrono::steady_clock::now();
    Structure structure = choose_structure(scene, level, {});
    const BspBuild build =
        build_bsp(structure.grid, structure.planes, structure.polygons, structure.box_min, structure.box_max);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double area_error = structure.area_m2 > 0.0 ? std::abs(area_m2(build) / structure.area_m2 - 1.0) : 0.0;
    JsonValue row = JsonValue::object();
    row.set("file", file.filename().string()).set("seconds", seconds);
    row.set("polygons", static_cast<std::uint64_t>(structure.polygons.size())).set("pieces", build.piece_count);
    row.set("leaves", build.tree.leaf_count).set("depth", build.depth);
    row.set("points", points).set("misclassified", misclassified(build.tree, points));
    row.set("relative_area_error", area_error);
    return row;
}

void measure_bsp(const BspMeasureArguments& arguments)
{
    require_outputs({{"--json", arguments.json}}, arguments.files);
    JsonValue rows = JsonValue::array();
    for (const std::filesystem::path& file : arguments.files) rows.push(measure_file(file, arguments.points));
    JsonValue json = JsonValue::object();
    json.set("measure", "bsp").set("rows", std::move(rows));
    if (!arguments.json.empty()) write_json(arguments.json, json);
    std::cout << json.text();
}

}  // namespace

void add_measure_bsp(CLI::App& measure)
{
    auto arguments = std::make_shared<BspMeasureArguments>();
    CLI::App* command =
        measure.add_subcommand("bsp", "Seconds, pieces, misclassified points and area error of the BSP");
    command->add_option("files", arguments->files, "Levels or models")->required();
    command->add_option("--points", arguments->points, "Points to classify")->check(whole_number_in(1, 1'000'000'000));
    add_json_argument(*command, arguments->json);
    command->callback([arguments] { measure_bsp(*arguments); });
}

}  // namespace hw
