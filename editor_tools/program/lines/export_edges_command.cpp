#include <fmt/format.h>

#include <numbers>

#include "hatchway/core/error.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/io/gltf/edge_export.hpp"
#include "hatchway/io/level/file.hpp"
#include "program/commands.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

struct ExportArguments {
    std::filesystem::path file;
    std::filesystem::path out;
    double crease_deg = 40.0;
};

void export_model_edges(const ExportArguments& arguments)
{
    if (arguments.out.extension() != ".glb")
        throw Error({.what = "--out " + arguments.out.string(), .expected = "a name that ends in .glb"});
    require_outputs({{"--out", arguments.out}}, {arguments.file});
    const Level level = read_level(arguments.file);
    require_distinct({{"--out", arguments.out}}, {level.scene_file});
    const EdgeExport counts = export_edges(level.scene_file, level.project_root, arguments.out,
                                           static_cast<float>(arguments.crease_deg * std::numbers::pi / 180.0));
    print_line(fmt::format("{} primitives: {} edges drawn, {} may be silhouettes; {} primitives skipped",
                           counts.primitives, counts.drawn_edges, counts.silhouette_edges, counts.skipped_primitives));
}

}  // namespace

void add_export_edges_command(CommandLine app)
{
    auto arguments = std::make_shared<ExportArguments>();
    CommandLine command = app.add_subcommand(
        "export-edges", "Writes a model with its drawn edges in it: EXT_mesh_primitive_edge_visibility");
    command.add_option("model", arguments->file, "A bare model, or a level").required().option_text("GLB|LEVEL");
    command.add_option("--out", arguments->out, "The model to write").required().option_text("FILE.glb");
    command.add_option("--crease-deg", arguments->crease_deg, "Edges folded by more are drawn; 40")
        .option_text("F")
        .check(number_in(0.1, 180.0));
    command.callback([arguments] { export_model_edges(*arguments); });
}

}  // namespace hw
