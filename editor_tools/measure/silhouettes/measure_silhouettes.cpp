// Milliseconds and errors of every way to find silhouettes, over the same views in one run. The reference computes with
// rational numbers and shares no code with what it judges. Edges that repair of the mesh changed count apart.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>

#include "hatchway/core/error.hpp"
#include "hatchway/core/limits.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/core/progress.hpp"
#include "hatchway/io/level/file.hpp"
#include "hatchway/io/model/import.hpp"
#include "measure/measure_result.hpp"
#include "measure/measures.hpp"
#include "measure/no_value.hpp"
#include "measure/random_seed.hpp"
#include "measure/silhouettes/silhouette_subject.hpp"
#include "measure/silhouettes/smooth_mesh.hpp"
#include "program/arguments.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

constexpr int kRounds = 3;
constexpr float kNoCreases = 3.2f;

struct SilhouetteMeasureArguments {
    std::vector<std::filesystem::path> files;
    std::vector<int> smooth;
    SilhouetteViews views;
    std::vector<double> offsets{0.0, 1e3, 1e5, 1e6};
    std::vector<double> node_offsets;
    std::vector<double> scales{1.0};
    MeasureResult result;
};

enum class Method { brute, candidates, hierarchy, automatic, openmesh, openmesh_kept };

struct Variant {
    Method method;
    FacingPrecision precision;
    const char* method_name;
    const char* precision_name;
};
constexpr std::array<Variant, 8> kVariants{
    {{Method::brute, FacingPrecision::exact, "brute", "exact"},
     {Method::candidates, FacingPrecision::exact, "candidates", "exact"},
     {Method::hierarchy, FacingPrecision::exact, "hierarchy", "exact"},
     {Method::automatic, FacingPrecision::exact, "auto", "exact"},
     {Method::brute, FacingPrecision::double_only, "brute", "double"},
     {Method::brute, FacingPrecision::single_only, "brute", "float"},
     {Method::openmesh, FacingPrecision::single_only, "openmesh", "float"},
     {Method::openmesh_kept, FacingPrecision::single_only, "openmesh kept", "float"}}};

bool is_openmesh(Method method)
{
    return method == Method::openmesh || method == Method::openmesh_kept;
}

struct Row {
    std::string model;
    Variant variant;
    SilhouettePlacement placement;
    std::vector<double> ms;
    std::uint64_t faces = 0;
    double faces_left = 1.0;  ///< Share of the model's faces before it was moved and scaled.
    std::uint64_t edges = 0;
    std::size_t views = 0;
    std::uint64_t expected = 0;        ///< Silhouettes of the file's triangles, all views.
    std::uint64_t edge_on = 0;         ///< Edges of faces in whose plane the eye is: the file leaves them open.
    SilhouetteErrors errors;           ///< Against the file's triangles, where repair changed nothing.
    SilhouetteErrors changed_errors;   ///< The same where it did.
    SilhouetteErrors repaired_errors;  ///< Against the surface after welding and repair.
    std::uint64_t changed_edges = 0;
    std::uint64_t refused_faces = 0;  ///< By OpenMesh: its mesh is another one there.
    SilhouetteCounters counters;
    std::uint64_t bytes = 0;
    std::uint64_t cluster_bytes = 0;  ///< Of these.
    double preprocess_s = 0.0;
};

double quantile(std::vector<double> values, double share)
{
    if (values.empty()) return measure::kNoValue;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

bool takes_clusters(const SilhouetteSubject& subject, Method method)
{
    const bool pays = subject.surface.faces.size() >= SurfaceOptions{}.cluster_from_faces;
    return method == Method::hierarchy || (method == Method::automatic && pays);
}

std::vector<OracleEdge> sorted(std::vector<OracleEdge> edges)
{
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

OracleEdge edge_between(const std::array<std::uint32_t, 2>& ends)
{
    return {std::min(ends[0], ends[1]), std::max(ends[0], ends[1])};
}

std::vector<OracleEdge> run_once(const SilhouetteSubject& subject, const Variant& variant, const Viewpoint& view,
                                 SilhouetteScratch& scratch, std::vector<int>& openmesh_edges, double& ms)
{
    const SilhouetteOptions options{
        .crease_rad = kNoCreases,
        .precision = variant.precision,
        .method = takes_clusters(subject, variant.method) ? SilhouetteMethod::hierarchy : SilhouetteMethod::brute};
    std::span<const std::uint32_t> edges;
    const auto start = std::chrono::steady_clock::now();
    if (variant.method == Method::openmesh)
        subject.half_edges->plain_silhouettes(view, openmesh_edges);
    else if (variant.method == Method::openmesh_kept)
        subject.half_edges->kept_facing_silhouettes(view, openmesh_edges);
    else if (variant.method == Method::candidates)
        edges = drawn_contours(subject.surface, view, options, scratch);
    else
        edges = all_silhouettes(subject.surface, view, options, scratch);
    ms = 1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

    std::vector<OracleEdge> found;
    if (is_openmesh(variant.method)) {
        for (const int edge : openmesh_edges) found.push_back(edge_between(subject.half_edges->edge_ends(edge)));
    } else {
        for (const std::uint32_t edge : edges) found.push_back(edge_between(edge_vertices(subject.surface, edge)));
    }
    return sorted(std::move(found));
}

/// The edges that the engine looks at for contours: it leaves out what is drawn anyway and what the reflex rule hides.
std::vector<OracleEdge> candidate_edges(const Surface& surface)
{
    const EdgeClasses classes = classes_at(surface, kNoCreases);
    std::vector<OracleEdge> candidates;
    for (const EdgeRange range : classes.candidates)
        for (std::uint32_t edge = range.begin; edge < range.end; ++edge)
            candidates.push_back(edge_between(edge_vertices(surface, edge)));
    return sorted(std::move(candidates));
}

std::vector<OracleEdge> common(const std::vector<OracleEdge>& a, const std::vector<OracleEdge>& b)
{
    std::vector<OracleEdge> both;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
    return both;
}

std::vector<OracleEdge> without(const std::vector<OracleEdge>& edges, const std::vector<OracleEdge>& others)
{
    std::vector<OracleEdge> left;
    std::set_difference(edges.begin(), edges.end(), others.begin(), others.end(), std::back_inserter(left));
    return left;
}

void add(SilhouetteErrors& sum, const SilhouetteErrors& part)
{
    sum.false_positives += part.false_positives;
    sum.false_negatives += part.false_negatives;
    sum.odd_vertices += part.odd_vertices;
}

void judge(const SilhouetteSubject& subject, const std::vector<OracleEdge>& found, std::size_t view, Row& row)
{
    std::vector<OracleEdge> of_surface = subject.of_surface[view], of_file = subject.of_file[view];
    const auto in_file = [&](const std::vector<OracleEdge>& edges) {
        return subject.file->edges_between(subject.surface.positions, edges);
    };
    if (row.variant.method == Method::candidates) {
        const std::vector<OracleEdge> candidates = candidate_edges(subject.surface);
        of_surface = common(candidates, of_surface);
        of_file = common(in_file(candidates), of_file);
    }
    const std::vector<OracleEdge> found_in_file = without(in_file(found), subject.edge_on[view]);
    const std::vector<OracleEdge>& changed = subject.changed;
    const SilhouetteOracle& oracle = *subject.file_oracle;
    row.expected += of_file.size();
    row.edge_on += subject.edge_on[view].size();
    add(row.errors, oracle.judge(without(found_in_file, changed), without(of_file, changed)));
    add(row.changed_errors, oracle.judge(common(found_in_file, changed), common(of_file, changed)));
    add(row.repaired_errors, subject.surface_oracle->judge(found, of_surface));
}

void measure_subject(const SilhouetteSubject& subject, Row& row)
{
    SilhouetteScratch scratch;
    std::vector<int> openmesh_edges;
    for (int round = 0; round < kRounds; ++round) {
        for (std::size_t view = 0; view < subject.views.size(); ++view) {
            double ms = 0.0;
            const auto found = run_once(subject, row.variant, subject.views[view], scratch, openmesh_edges, ms);
            row.ms.push_back(ms);
            if (round == 0) judge(subject, found, view, row);
        }
    }
    row.views = subject.views.size();
    row.changed_edges = subject.changed.size();
    row.refused_faces = is_openmesh(row.variant.method) ? subject.half_edges->refused_faces() : 0;
    row.faces = subject.surface.faces.size();
    row.edges = subject.surface.edges.size();
    row.counters = scratch.counters;
    const OutlineBytes bytes = outline_bytes(subject.surface);
    const bool has_clusters = takes_clusters(subject, row.variant.method);
    row.cluster_bytes = has_clusters ? bytes.clusters : 0;
    row.bytes = bytes.edges + bytes.planes + row.cluster_bytes;
    row.preprocess_s = subject.preprocess_s + (has_clusters ? subject.cluster_s : 0.0);
}

double share(std::uint64_t part, std::uint64_t whole)
{
    return measure::share_of(static_cast<double>(part), static_cast<double>(whole));
}

/// Errors say nothing where OpenMesh's mesh is not ours.
bool is_judged(const Row& row)
{
    return row.refused_faces == 0;
}

/// Candidates are what the engine says, so none of them can be missing, and they make no closed loops.
bool has_loops(const Row& row)
{
    return is_judged(row) && row.variant.method != Method::candidates;
}

void set_errors(JsonValue& json, const Row& row, const std::string& prefix, const SilhouetteErrors& errors)
{
    if (is_judged(row)) json.set(prefix + "fp", std::uint64_t{errors.false_positives});
    if (has_loops(row)) json.set(prefix + "fn", std::uint64_t{errors.false_negatives});
}

JsonValue row_json(const Row& row)
{
    const double median = quantile(row.ms, 0.5);
    const double calls = static_cast<double>(row.ms.size());
    JsonValue json = JsonValue::object();
    json.set("model", row.model).set("method", row.variant.method_name).set("precision", row.variant.precision_name);
    json.set("offset", row.placement.offset).set("moved", row.placement.is_by_node ? "node" : "vertices");
    json.set("scale", row.placement.scale).set("faces", row.faces).set("faces_left", row.faces_left);
    json.set("ms_median", median).set("ms_p95", quantile(row.ms, 0.95));
    json.set("ns_per_edge", 1e6 * median / static_cast<double>(std::max<std::uint64_t>(row.edges, 1)));
    json.set("views", std::uint64_t{row.views}).set("expected", row.expected);
    json.set("edge_on", row.edge_on);
    set_errors(json, row, "", row.errors);
    json.set("changed_edges", row.changed_edges);
    if (row.changed_edges > 0) {
        set_errors(json, row, "changed_", row.changed_errors);
    } else {
        json.set("changed_fp", measure::kNoValue).set("changed_fn", measure::kNoValue);
    }
    set_errors(json, row, "repaired_", row.repaired_errors);
    if (has_loops(row)) json.set("odd", std::uint64_t{row.repaired_errors.odd_vertices});
    json.set("refused_faces", row.refused_faces);
    json.set("fallback", share(row.counters.exact_stage, row.counters.faces_tested));
    json.set("double_stage", share(row.counters.double_stage, row.counters.faces_tested));
    json.set("tested_share", static_cast<double>(row.counters.edges_tested) / calls /
                                 static_cast<double>(std::max<std::uint64_t>(row.edges, 1)));
    if (row.cluster_bytes > 0) json.set("cluster_bytes_an_edge", share(row.cluster_bytes, row.edges));
    json.set("bytes", row.bytes).set("preprocess_s", row.preprocess_s);
    return json;
}

constexpr const char* kHeading = "{:<24} {:<13} {:<6} {:>8} {:<8} {:>8} {:>9} {:>9} {:>9} {:>13} {:>13} {:>13} {:>5}\n";

std::string errors_text(const Row& row, const SilhouetteErrors& errors)
{
    return fmt::format("{}, {}", is_judged(row) ? fmt::format("{}", errors.false_positives) : "-",
                       has_loops(row) ? fmt::format("{}", errors.false_negatives) : "-");
}

std::string row_text(const Row& row)
{
    return fmt::format(kHeading, row.model, row.variant.method_name, row.variant.precision_name,
                       fmt::format("{:.0e}", row.placement.offset), row.placement.is_by_node ? "node" : "vertices",
                       fmt::format("{:.0e}", row.placement.scale), fmt::format("{:.3f}", quantile(row.ms, 0.5)),
                       fmt::format("{:.3f}", quantile(row.ms, 0.95)), row.expected, errors_text(row, row.errors),
                       row.changed_edges > 0 ? errors_text(row, row.changed_errors) : "-",
                       errors_text(row, row.repaired_errors),
                       has_loops(row) ? fmt::format("{}", row.repaired_errors.odd_vertices) : "-");
}

/// All primitives of a model as one mesh of bare triangles, object space.
MeshData merged_mesh(const std::filesystem::path& file)
{
    const Level level = read_level(file);
    const Scene scene = import_model(level.scene_file, level.project_root);
    MeshData merged;
    for (const MeshData& mesh : scene.meshes) {
        const auto first = static_cast<std::uint32_t>(merged.positions.size());
        merged.positions.insert(merged.positions.end(), mesh.positions.begin(), mesh.positions.end());
        for (const std::uint32_t index : mesh.indices) merged.indices.push_back(first + index);
    }
    return merged;
}

struct NamedMesh {
    std::string name;
    MeshData mesh;
};

std::vector<NamedMesh> meshes_of(const SilhouetteMeasureArguments& arguments)
{
    std::vector<NamedMesh> meshes;
    for (const auto& file : arguments.files) meshes.push_back({file.stem().string(), merged_mesh(file)});
    for (const int triangles : arguments.smooth) {
        meshes.push_back({fmt::format("smooth_{}", triangles), smooth_mesh(static_cast<std::uint32_t>(triangles))});
    }
    if (meshes.empty()) throw Error({.what = "no model to measure", .expected = "models, or sizes for --smooth"});
    return meshes;
}

std::vector<SilhouettePlacement> placements_of(const SilhouetteMeasureArguments& arguments)
{
    std::vector<SilhouettePlacement> placements;
    for (const bool is_by_node : {false, true})
        for (const double offset : is_by_node ? arguments.node_offsets : arguments.offsets)
            for (const double scale : arguments.scales) placements.push_back({offset, scale, is_by_node});
    return placements;
}

/// With a warning where there are none: such a model is judged by nothing.
bool has_silhouettes(const std::string& name, const SilhouetteSubject& subject)
{
    const auto& views = subject.of_file;
    if (std::any_of(views.begin(), views.end(), [](const auto& edges) { return !edges.empty(); })) return true;
    log_warning(name + ": no edge is a silhouette from any view: not measured");
    return false;
}

void measure_silhouettes(const SilhouetteMeasureArguments& arguments)
{
    require_outputs({arguments.result.output()}, arguments.files);
    JsonValue rows = JsonValue::array();
    bool is_empty = true;
    const std::vector<NamedMesh> meshes = meshes_of(arguments);
    const std::vector<SilhouettePlacement> placements = placements_of(arguments);
    Progress progress("Measuring silhouettes", meshes.size() * placements.size());
    print_lines(fmt::format(kHeading, "model", "method", "number", "offset", "of", "scale", "median ms", "p95 ms",
                            "expected", "false, missed", "changed", "repaired", "odd"));
    for (const NamedMesh& named : meshes) {
        const std::size_t whole_faces = whole_faces_of(named.mesh);
        for (const SilhouettePlacement& placement : placements) {
            progress.advance();
            const auto subject = silhouette_subject(named.mesh, placement, whole_faces, arguments.views);
            if (!subject || !has_silhouettes(named.name, *subject)) continue;
            for (const Variant& variant : kVariants) {
                Row row{.model = named.name, .variant = variant, .placement = placement};
                measure_subject(*subject, row);
                row.faces_left = static_cast<double>(row.faces) / static_cast<double>(whole_faces);
                rows.push(row_json(row));
                is_empty = false;
                print_lines(row_text(row));
            }
        }
    }
    if (is_empty)
        throw Error({.what = "nothing was measured",
                     .expected = "models that keep their faces at that --offset and --scale, with edges of two faces"});
    arguments.result.write(JsonValue::object()
                               .set("views", arguments.views.around)
                               .set("random_views", arguments.views.random)
                               .set("is_orthographic", arguments.views.is_orthographic)
                               .set("rows", std::move(rows)));
}

}  // namespace

void add_measure_silhouettes(CommandLine measure)
{
    auto arguments = std::make_shared<SilhouetteMeasureArguments>();
    CommandLine command =
        measure.add_subcommand("silhouettes", "Time and errors of every way to find silhouette edges");
    command.add_option("models", arguments->files, "Models or levels").option_text("MODEL...");
    command.add_option("--smooth", arguments->smooth, "Add bumpy spheres of so many triangles, to see how a cost grows")
        .delimiter(',')
        .option_text("LIST")
        .check(whole_number_in(64, 10'000'000));
    command.add_option("--views", arguments->views.around, "Views around the model; 26")
        .option_text("N")
        .check(whole_number_in(1, 100'000));
    command.add_option("--random", arguments->views.random, "Random views in addition, the same in each run; 0")
        .option_text("N")
        .check(whole_number_in(0, 1'000'000));
    add_seed(command, arguments->views.seed, "random views");
    command.add_flag("--orthographic", arguments->views.is_orthographic, "Look from directions, not from eyes");
    command.add_option("--offset", arguments->offsets, "Move the vertices, in floats; 0,1e3,1e5,1e6")
        .delimiter(',')
        .option_text("LIST")
        .check(number_in(0.0, limits::kMaxCoordinate));
    command
        .add_option("--node-offset", arguments->node_offsets,
                    "Also turn the model's node and move it, in doubles; none")
        .delimiter(',')
        .option_text("LIST")
        .check(number_in(0.0, limits::kMaxCoordinate));
    command.add_option("--scale", arguments->scales, "Scale the model first; 1")
        .delimiter(',')
        .option_text("LIST")
        .check(number_in(1e-9, 1e9));
    arguments->result.add_to(command);
    command.callback([arguments] { measure_silhouettes(*arguments); });
}

}  // namespace hw
