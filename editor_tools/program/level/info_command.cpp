#include <fmt/format.h>

#include <algorithm>

#include "hatchway/core/log.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/drawing/scene_surfaces.hpp"
#include "hatchway/io/json/out.hpp"
#include "hatchway/stage/compiled_world.hpp"
#include "hatchway/stage/level_styles.hpp"
#include "hatchway/stage/level_world.hpp"
#include "program/arguments.hpp"
#include "program/commands.hpp"
#include "program/level/hatch_info.hpp"
#include "program/level/node_list.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

struct InfoArguments {
    std::filesystem::path file;
    std::filesystem::path json;
    std::filesystem::path cache;
    bool has_nodes = false;
    std::string hatch = kModelHatching;
};

/// Sums over meshes, each counted once however often it is used.
struct MeshTotals {
    SurfaceReport report;
    std::uint64_t edges = 0;
    OutlineBytes bytes;
    std::uint64_t faces = 0;

    double per_edge(std::size_t sum) const
    {
        return edges ? static_cast<double>(sum) / static_cast<double>(edges) : 0.0;
    }
    double per_face(std::size_t sum) const
    {
        return faces ? static_cast<double>(sum) / static_cast<double>(faces) : 0.0;
    }
};

MeshTotals totals_of(const Scene& scene)
{
    SceneSurfaces surfaces(scene);
    for (ObjectId id = 0; id < scene.objects.size(); ++id) surfaces.of(id);
    MeshTotals totals;
    totals.report.flipped_faces = scene.turned_triangles;
    totals.report.doubled_faces = scene.left_out_triangles;
    for (const auto& [key, surface] : surfaces.all()) {
        const SurfaceReport& report = surface.report;
        totals.report.triangles_in += report.triangles_in;
        totals.report.removed_faces += report.removed_faces;
        totals.report.doubled_faces += report.doubled_faces;
        totals.report.collinear_faces += report.collinear_faces;
        totals.report.needle_faces += report.needle_faces;
        totals.report.flipped_faces += report.flipped_faces;
        totals.report.inconsistent_edges += report.inconsistent_edges;
        totals.report.border_edges += report.border_edges;
        totals.report.complex_edges += report.complex_edges;
        totals.report.stitched_edges += report.stitched_edges;
        totals.report.pinholes += report.pinholes;
        totals.report.t_junction_edges += report.t_junction_edges;
        totals.report.artist_edges += report.artist_edges;
        totals.report.components += report.components;
        totals.report.closed_components += report.closed_components;
        totals.report.inward_components += report.inward_components;
        totals.report.reflex_rule_components += report.reflex_rule_components;
        totals.edges += surface.edges.size();
        const OutlineBytes bytes = outline_bytes(surface);
        totals.faces += surface.faces.size();
        totals.bytes.edges += bytes.edges;
        totals.bytes.planes += bytes.planes;
        totals.bytes.clusters += bytes.clusters;
    }
    return totals;
}

/// Of those with faces: what is hidden has none.
std::uint64_t mesh_count(const Scene& scene)
{
    const auto has_faces = [](const MeshData& mesh) { return !mesh.indices.empty(); };
    return static_cast<std::uint64_t>(std::ranges::count_if(scene.meshes, has_faces));
}

JsonValue info_json(const LevelWorld& world, const CompiledLevel& compiled, const MeshTotals& totals)
{
    const VisibilityStats& visibility = compiled.visibility.stats;
    const Scene& scene = world.scene;
    const SurfaceReport& report = totals.report;
    JsonValue json = JsonValue::object();
    json.set("triangles", report.triangles_in).set("triangles_drawn", drawn_triangle_count(scene));
    json.set("objects", static_cast<std::uint64_t>(scene.objects.size()));
    json.set("hidden_objects", static_cast<std::uint64_t>(scene.hidden.size()));
    json.set("meshes", mesh_count(scene));
    json.set("materials", static_cast<std::uint64_t>(scene.materials.size()));
    json.set("faces_removed", report.removed_faces).set("collinear_faces", report.collinear_faces);
    json.set("doubled_faces", report.doubled_faces).set("needle_faces", report.needle_faces);
    json.set("components", report.components).set("closed_components", report.closed_components);
    json.set("inward_components", report.inward_components);
    json.set("reflex_rule_components", report.reflex_rule_components);
    json.set("edges", totals.edges).set("borders", report.border_edges);
    json.set("t_junction_edges", report.t_junction_edges).set("pinholes", report.pinholes);
    json.set("stitched_edges", report.stitched_edges).set("complex_edges", report.complex_edges);
    json.set("artist_edges", report.artist_edges).set("inconsistent_edges", report.inconsistent_edges);
    json.set("flips_repaired", report.flipped_faces);
    json.set("bytes_per_edge", totals.per_edge(totals.bytes.edges));
    json.set("plane_bytes_per_face", totals.per_face(totals.bytes.planes));
    json.set("cluster_bytes_per_edge", totals.per_edge(totals.bytes.clusters));
    json.set("structure_polygons", visibility.structure_polygons);
    json.set("leaves", visibility.leaves).set("portals", visibility.portals);
    json.set("coarse_portals", visibility.coarse_portals);
    json.set("average_visible_share", visibility.average_visible_share);
    json.set("visibility_s", visibility.seconds).set("is_compiled_level_used", compiled.is_from_cache);
    return json;
}

void print_info(const LevelWorld& world, const CompiledLevel& compiled, const MeshTotals& totals)
{
    const VisibilityStats& visibility = compiled.visibility.stats;
    const SurfaceReport& report = totals.report;
    print_lines(fmt::format(
        "model       {} objects{}, {} meshes, {} triangles ({} drawn)\n"
        "faces       {} removed, {} doubled, {} collinear, {} needles, {} flips repaired\n"
        "components  {}, {} closed ({} of them inward), {} with the right to the reflex rule\n"
        "edges       {}: {} borders, {} complex, {} artist's, {} stitched, {} T-junctions and {} pinholes closed, {} "
        "inconsistent\n"
        "bytes       {:.1f} an edge, crease or candidate, and {:.1f} in clusters; {:.1f} a face in planes\n"
        "visibility  {} leaves, {} portals ({} coarse), from {} polygons; a leaf sees {:.1f} % of the triangles; "
        "{}\n",
        world.scene.objects.size(), hidden_text(world.scene), mesh_count(world.scene), report.triangles_in,
        drawn_triangle_count(world.scene), report.removed_faces, report.doubled_faces, report.collinear_faces,
        report.needle_faces, report.flipped_faces, report.components, report.closed_components,
        report.inward_components, report.reflex_rule_components, totals.edges, report.border_edges,
        report.complex_edges, report.artist_edges, report.stitched_edges, report.t_junction_edges, report.pinholes,
        report.inconsistent_edges, totals.per_edge(totals.bytes.edges), totals.per_edge(totals.bytes.clusters),
        totals.per_face(totals.bytes.planes), visibility.leaves, visibility.portals, visibility.coarse_portals,
        visibility.structure_polygons, 100.0 * visibility.average_visible_share,
        compiled.is_from_cache ? "from the compiled level" : fmt::format("{:.2f} s", visibility.seconds)));
}

/// The compiled level where there is one; else it is compiled, and kept only where --cache says.
CompiledLevel compiled_level(const Level& level, const LevelWorld& world, const CompiledCache& cache)
{
    if (!cache.folder.empty()) return find_or_compile_world(level, world, {}, &cache);
    std::optional<CompiledLevel> found = find_compiled_world(level, world, {}, cache);
    return found ? std::move(*found) : compile_world(level, world, {});
}

void info(const InfoArguments& arguments)
{
    const std::vector<OutputFile> outputs{{"--json", arguments.json}};
    require_outputs(outputs, {arguments.file});
    const Level level = read_level_with(arguments.file, {});
    if (!arguments.cache.empty()) require_writable_folder(arguments.cache, "--cache");
    const CompiledCache cache{arguments.cache};
    const auto world = open_world(level);
    forget_unknown_styles(level, PluginRegistry(), world->scene);
    for (const std::string& doubt : world->scene.doubts) log_warning(doubt);
    const CompiledLevel compiled = compiled_level(level, *world, cache);
    require_unread(outputs);
    const MeshTotals totals = totals_of(world->scene);
    const HatchTotals hatching = hatch_totals(world->scene, arguments.hatch);
    print_info(*world, compiled, totals);
    print_lines(hatch_text(hatching));
    if (arguments.has_nodes)
        for (const std::string& line : node_lines(level, world->scene)) print_line(line);
    if (arguments.json.empty()) return;
    JsonValue json = info_json(*world, compiled, totals);
    add_hatch_json(hatching, json);
    if (arguments.has_nodes) json.set("nodes", nodes_json(level, world->scene));
    write_json(arguments.json, json);
}

}  // namespace

void add_info_command(CommandLine app)
{
    auto arguments = std::make_shared<InfoArguments>();
    CommandLine command =
        app.add_subcommand("info", "Says what a model is made of: faces, edges, components, visibility");
    command.add_option("level", arguments->file, "A bare model or a level").required().option_text("MODEL|LEVEL");
    command.add_flag("--nodes", arguments->has_nodes,
                     "List what a level's rules can name, node paths and materials, and what they say of each");
    command
        .add_option(
            "--hatch", arguments->hatch,
            "What strokes follow: model (a box for meshes without texture coordinates), box, cylinder, principal")
        .check(one_of({"model", "box", "cylinder", "principal"}));
    add_cache_argument(command, arguments->cache);
    add_json_argument(command, arguments->json);
    command.callback([arguments] { info(*arguments); });
}

}  // namespace hw
