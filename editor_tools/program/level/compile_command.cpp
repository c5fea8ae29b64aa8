#include <fmt/format.h>

#include "hatchway/core/files/files.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/io/compiled/level.hpp"
#include "hatchway/io/compiled/portal_file.hpp"
#include "hatchway/io/compiled/write.hpp"
#include "hatchway/io/json/out.hpp"
#include "hatchway/stage/level_world.hpp"
#include "program/arguments.hpp"
#include "program/commands.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

namespace fs = std::filesystem;

struct CompileArguments {
    fs::path file;
    std::string effort = "full";
    int threads = 0;
    fs::path out;
    fs::path cache;
    fs::path prt;
    fs::path json;
};

/// Portal files are in units of about an inch and a quarter; a power of two keeps every digit.
constexpr double kUnitsPerMetre = 32.0;

std::string portal_file_text(PortalGraph graph)
{
    for (DirectedPortal& portal : graph.portals)
        for (glm::dvec3& corner : portal.winding) corner *= kUnitsPerMetre;
    return portals_text(graph);
}

JsonValue result_json(const fs::path& out, const CompiledLevel& compiled)
{
    const VisibilityStats& stats = compiled.visibility.stats;
    JsonValue json = JsonValue::object();
    json.set("file", out.string()).set("key", fmt::format("{:016x}", compiled.key));
    json.set("polygons", stats.structure_polygons + stats.detail_polygons);
    json.set("leaves", stats.leaves).set("clusters", stats.clusters).set("portals", stats.portals);
    json.set("coarse_portals", stats.coarse_portals).set("average_visible_share", stats.average_visible_share);
    json.set("bytes", static_cast<std::uint64_t>(fs::file_size(out))).set("seconds", stats.seconds);
    return json;
}

void compile(const CompileArguments& arguments)
{
    const Level level = read_level_with(arguments.file, {});
    if (!arguments.cache.empty()) require_writable_folder(arguments.cache, "--cache");
    const fs::path out =
        arguments.out.empty() ? opened_cache({arguments.cache}).path() / compiled_level_name(level) : arguments.out;
    const std::vector<OutputFile> outputs{
        {"--out", arguments.out}, {"--prt", arguments.prt}, {"--json", arguments.json}};
    require_outputs(outputs, {arguments.file});
    const auto world = open_world(level);
    require_unread(outputs);
    VisibilityOptions options;
    options.effort = pvs_effort(arguments.effort);
    options.threads = arguments.threads;
    const CompiledLevel compiled = compile_world(level, *world, options);
    write_file_atomically(out, std::span<const std::byte>(compiled_level_bytes(compiled, world->chunks)));
    if (!arguments.prt.empty()) write_file_atomically(arguments.prt, portal_file_text(compiled.visibility.portals));
    if (!arguments.json.empty()) write_json(arguments.json, result_json(out, compiled));
    const VisibilityStats& stats = compiled.visibility.stats;
    print_line(
        fmt::format("{}: {} leaves in {} clusters, {} portals ({} coarse); {:.1f} % of the triangles may be "
                    "seen from a cluster; {} bytes, {:.2f} s",
                    out.string(), stats.leaves, stats.clusters, stats.portals, stats.coarse_portals,
                    100.0 * stats.average_visible_share, fs::file_size(out), stats.seconds));
}

}  // namespace

void add_compile_command(CommandLine app)
{
    auto arguments = std::make_shared<CompileArguments>();
    CommandLine command =
        app.add_subcommand("compile", "Compiles what can be seen from where, as walk does beside the first walk");
    command.add_option("level", arguments->file, "A level or a bare model").required().option_text("LEVEL|MODEL");
    command.add_option("-j,--threads", arguments->threads, "Threads; 0 for all").check(whole_number_in(0, 1024));
    command.add_option("--pvs", arguments->effort, "How tight; walk and render take what is at least full")
        .check(one_of(kPvsEfforts));
    command.add_option("--out", arguments->out, "The file; default: in the cache, where walk and render find it")
        .option_text("FILE");
    add_cache_argument(command, arguments->cache);
    command
        .add_option("--prt", arguments->prt,
                    "Write the portals as a Quake portal file, too: PRT1 text, 32 units a metre")
        .option_text("FILE");
    add_json_argument(command, arguments->json);
    command.callback([arguments] { compile(*arguments); });
}

}  // namespace hw
